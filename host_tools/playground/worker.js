// Runs inkcell-fontgen for convert.mjs; build.mjs puts InkcellFontgen and
// runFontgen before it.
onmessage = async ({data: {module, files, args}}) => {
  const progress = (done, count) => postMessage({done, count});
  try {
    postMessage(await runFontgen(InkcellFontgen, module, files, args, progress));
  } catch (error) {
    postMessage({code: 1, err: `the generator has ended: ${error}`, files: {}});
  }
};
