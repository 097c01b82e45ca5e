# The Debian packages that the project needs, and a function that installs them.
#
#   . host_tools/setup.sh
#   inkcell_setup demo     # the generator, the tools and the emulated boards
#   inkcell_setup studio   # these, and what INKCELL_STUDIO needs on top
#   inkcell_setup first    # demo, and what the tests' first lane needs on top
#   inkcell_setup tests    # first, studio, and what the other tests need on top
#   inkcell_setup web      # what builds the page of host_tools/playground
#   inkcell_setup exe      # what builds the generator for Windows, and runs it
#   inkcell_setup static   # what builds the generator for any Linux
#   inkcell_setup deb      # demo, and what makes packages of Debian on top
#   inkcell_setup fonts    # the faces of host_tools/release/fonts.py, but npm's
#   inkcell_setup site     # the documents as a site
#   inkcell_setup reading  # what reads and judges small text
#   inkcell_setup bare     # what makes the machine of tests/bare.sh
#   inkcell_setup pieces   # what takes the generator's pieces of a release
#   inkcell_setup packages NAME...
#
# Installs missing packages as root or through sudo. If neither is allowed,
# prints the command and ends the calling script. The test build.debian_packages
# fails if the list demo or tests lacks a package, tests/web.sh if web does.

inkcell_packages_demo="g++ cmake ninja-build python3
  libfreetype-dev libharfbuzz-dev libfribidi-dev libpolyclipping-dev
  libcli11-dev nlohmann-json3-dev libpugixml-dev libpng-dev zlib1g-dev
  libgif-dev nettle-dev
  gcc-arm-none-eabi gcc-riscv64-unknown-elf
  qemu-system-arm qemu-system-misc fonts-dejavu-core"

inkcell_packages_studio="$inkcell_packages_demo libsdl2-dev libimgui-dev
  pkg-config liblua5.4-dev fonts-roboto-unhinted"

inkcell_packages_reading="python3 python3-freetype tesseract-ocr
  tesseract-ocr-eng"

inkcell_packages_site="python3 doxygen mkdocs python3-pygments"

inkcell_packages_first="$inkcell_packages_demo
  git ccache libgtest-dev python3-fonttools unicode-data fonts-roboto-unhinted
  fonts-liberation fonts-inter-variable fonts-lato fonts-noto-cjk
  fonts-lohit-deva fonts-tlwg-loma-ttf unifont xfonts-terminus"

inkcell_packages_tests="$inkcell_packages_first $inkcell_packages_studio
  clang lld nodejs make meson cargo rustc rust-src librust-cc-dev
  libnewlib-arm-none-eabi picolibc-riscv64-unknown-elf
  libclang-rt-dev g++-powerpc-linux-gnu qemu-user
  fonts-dejavu-extra fonts-inter fonts-jetbrains-mono fonts-noto-core libharfbuzz-bin
  hunspell-ar hunspell-he hunspell-ne hunspell-th hunspell-vi
  aspell aspell-fa aspell-hi aspell-mr
  librsvg2-bin xvfb xdotool fontmake python3-fontforge fonts-open-sans
  $inkcell_packages_reading $inkcell_packages_site"

inkcell_packages_web="cmake ninja-build clang lld emscripten nodejs dpkg-dev zopfli
  libcli11-dev nlohmann-json3-dev fonts-dejavu-core"

inkcell_packages_exe="cmake ninja-build g++-mingw-w64-x86-64-posix wine wine64
  dpkg-dev libcli11-dev nlohmann-json3-dev"

inkcell_packages_static="cmake ninja-build g++ dpkg-dev libcli11-dev
  nlohmann-json3-dev"

inkcell_packages_deb="$inkcell_packages_demo dpkg-dev help2man"

inkcell_packages_fonts="python3 fonts-inter fonts-noto-core
  fonts-roboto-unhinted fonts-open-sans fonts-manrope fonts-dejavu-core
  fonts-b612 fonts-crosextra-caladea fonts-jetbrains-mono fonts-firacode
  fonts-bebas-neue fonts-quicksand fonts-roboto-slab fonts-dseg fonts-dotgothic16
  fonts-spleen fonts-font-awesome fonts-material-design-icons-iconfont"

inkcell_packages_bare="git debootstrap debian-archive-keyring"

inkcell_packages_pieces="$inkcell_packages_bare g++ unzip busybox-static wine wine64
  nodejs chromium lintian python3-venv python3-license-expression"

# The packages of "$@" that are not installed, each once.
inkcell_missing() {
  for package in $(printf '%s\n' "$@" | awk '!seen[$0]++'); do
    dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null |
      grep -qx installed || printf ' %s' "$package"
  done
}

inkcell_setup() {
  case $1 in
    demo) inkcell_wanted=$inkcell_packages_demo ;;
    studio) inkcell_wanted=$inkcell_packages_studio ;;
    first) inkcell_wanted=$inkcell_packages_first ;;
    tests) inkcell_wanted=$inkcell_packages_tests ;;
    web) inkcell_wanted=$inkcell_packages_web ;;
    exe) inkcell_wanted=$inkcell_packages_exe ;;
    static) inkcell_wanted=$inkcell_packages_static ;;
    deb) inkcell_wanted=$inkcell_packages_deb ;;
    fonts) inkcell_wanted=$inkcell_packages_fonts ;;
    site) inkcell_wanted=$inkcell_packages_site ;;
    reading) inkcell_wanted=$inkcell_packages_reading ;;
    bare) inkcell_wanted=$inkcell_packages_bare ;;
    pieces) inkcell_wanted=$inkcell_packages_pieces ;;
    packages) shift; inkcell_wanted=$* ;;
    *)
      echo "inkcell_setup demo|studio|first|tests|web|exe|static|deb|fonts|site|reading|bare|pieces|packages NAME..." >&2
      exit 2
      ;;
  esac
  inkcell_missing=$(inkcell_missing $inkcell_wanted)
  [ -n "$inkcell_missing" ] || return 0
  if [ "$(id -u)" = 0 ]; then
    inkcell_root=
  elif command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
    inkcell_root=sudo
  else
    echo "Please install what is missing, and start this again:" >&2
    echo "  apt-get update" >&2
    echo "  apt-get install --no-install-recommends$inkcell_missing" >&2
    exit 1
  fi
  echo "Installing$inkcell_missing"
  if ! { $inkcell_root apt-get -qq update &&
    $inkcell_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y \
      --no-install-recommends $inkcell_missing >/dev/null; }; then
    echo "apt-get could not install:$inkcell_missing" >&2
    exit 1
  fi
}
