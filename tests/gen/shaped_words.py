"""Shapes words of Debian's lists by the device's code and by hb-shape.

All must be equal, glyphs and units: Arabic and Persian, with and without
vowels, Hebrew with and without points, Thai, Vietnamese of letters and marks
(NFD), Hindi, Marathi and Nepali. Vowels and points are put on real words at
random, as the lists have none.

Usage: shaped_words.py FONTGEN INSPECT FOLDER [words|sentences|random [COUNT]]

words       5,000 words of each list
sentences   1,000 of each list: words, numbers, brackets and points
random      10,000 strings of the characters of each face's words, joiners and
            brackets; 99.5 % must be equal, and all others are told
"""
import json
import pathlib
import random
import re
import subprocess
import sys
import unicodedata

FONTS = pathlib.Path("/usr/share/fonts/truetype")
DEJAVU = FONTS / "dejavu/DejaVuSans.ttf"
NOTO = FONTS / "noto"
LISTS = pathlib.Path("/usr/share/hunspell")

HARAKAT = ["\u064e", "\u064f", "\u0650", "\u0652", "\u0651\u064e",
           "\u0651\u0650", "\u0651\u064f"]
# Letters that take no vowel.
BARE = "\u0627\u0649\u0622\u0621\u0625\u0623\u0624\u0626\u0629\u0648"
NIQQUD = list("\u05b0\u05b4\u05b5\u05b6\u05b7\u05b8\u05b9\u05bb")


DEVANAGARI = "[\u0900-\u097f\u200c\u200d]+"


def hunspell(name, letters):
    text = (LISTS / name).read_text(encoding="utf-8", errors="ignore")
    words = [re.split(r"[/\t]", line)[0].strip()
             for line in text.splitlines()[1:]]
    return [word for word in words if re.fullmatch(letters, word)]


def aspell(language, letters):
    text = subprocess.run(["aspell", "-d", language, "dump", "master"],
                          check=True, capture_output=True).stdout
    words = text.decode("utf-8", "ignore").split("\n")
    words = [word.split("/")[0] for word in words]
    return [word for word in words if re.fullmatch(letters, word)]


def with_harakat(word):
    return "".join(
        c + (random.choice(HARAKAT)
             if "\u0620" <= c <= "\u064a" and c not in BARE else "")
        for c in word)


def with_points(word):
    out = ""
    for c in word:
        out += c
        if "\u05d0" <= c <= "\u05ea":
            if c == "\u05e9":
                out += random.choice("\u05c1\u05c2")
            if random.random() < 0.2:
                out += "\u05bc"
            out += random.choice(NIQQUD)
    return out


def word_lists(count):
    """Words by the name of their list."""
    random.seed(1)
    arabic = "[\u0600-\u06ff\u200c]+"
    lists = {"ar": hunspell("ar.dic", arabic), "fa": aspell("fa", arabic),
             "he": hunspell("he_IL.dic", "[\u0590-\u05ff]+"),
             "th": hunspell("th_TH.dic", "[\u0e00-\u0e7f]+"),
             "vi": hunspell("vi_VN.dic", r"\w+"),
             "hi": aspell("hi", DEVANAGARI), "mr": aspell("mr", DEVANAGARI),
             "ne": hunspell("ne_NP.dic", DEVANAGARI)}
    for name, words in lists.items():
        words = sorted(set(words))
        lists[name] = random.sample(words, min(count, len(words)))
        if len(lists[name]) < min(count, 5000):
            raise SystemExit(f"{name}: only {len(lists[name])} words")
    lists["vi"] = [unicodedata.normalize("NFD", word) for word in lists["vi"]]
    lists["ar vowels"] = [with_harakat(word) for word in lists["ar"]]
    lists["he points"] = [with_points(word) for word in lists["he"]]
    return lists


# Name, face, script of --shape and of hb-shape, lists.
CASES = [
    ("DejaVu Sans", DEJAVU, "arab", "Arab", ["ar", "fa", "ar vowels"]),
    ("Noto Naskh", NOTO / "NotoNaskhArabic-Regular.ttf", "arab", "Arab",
     ["ar", "fa", "ar vowels"]),
    ("Noto Sans Arabic", NOTO / "NotoSansArabic-Regular.ttf", "arab", "Arab",
     ["ar", "fa", "ar vowels"]),
    ("Noto Sans Hebrew", NOTO / "NotoSansHebrew-Regular.ttf", "hebr", "Hebr",
     ["he", "he points"]),
    ("Noto Sans Thai", NOTO / "NotoSansThai-Regular.ttf", "thai", "Thai",
     ["th"]),
    ("DejaVu Sans", DEJAVU, "latn", "Latn", ("vi",)),
    ("Noto Sans", NOTO / "NotoSans-Regular.ttf", "latn", "Latn", ("vi",)),
    ("Lohit", FONTS / "lohit-devanagari/Lohit-Devanagari.ttf", "deva", "Deva",
     ["hi", "mr", "ne"]),
    ("Noto Sans Devanagari", NOTO / "NotoSansDevanagari-Regular.ttf", "deva",
     "Deva", ["hi", "mr", "ne"]),
    # Letters and marks compose without a script.
    ("DejaVu Sans without --shape", DEJAVU, "", "Latn", ("vi",)),
    ("Noto Sans without --shape", NOTO / "NotoSans-Regular.ttf", "", "Latn",
     ("vi",)),
]


PUNCTUATION = " .,:;!?-()[]{}<>\u00ab\u00bb0123456789"
JOINERS = "\u200c\u200d"


def sentences_of(words, count):
    """Sentences of words, numbers and brackets."""
    def number():
        return str(random.randrange(10 ** random.randint(1, 6)))

    def bracketed(text):
        left, right = random.choice(("()", "[]", "{}", "<>",
                                     "\u00ab\u00bb"))
        return left + text + right

    out = []
    for _ in range(count):
        parts = [random.choice(words) for _ in range(random.randint(3, 8))]
        parts.insert(random.randrange(1, len(parts)), number())
        at = random.randrange(1, len(parts))
        parts[at] = bracketed(parts[at])
        at = random.randrange(1, len(parts))
        parts[at] += random.choice(",;:-")
        out.append(" ".join(parts) + random.choice(".!?"))
    return out


def random_of(words, count):
    """Strings of the characters of words, which begin with one of them that is
    no mark."""
    characters = sorted(set("".join(words)))
    letters = [c for c in characters
               if unicodedata.category(c).startswith("L")]
    kinds = [characters] * 12 + [PUNCTUATION, JOINERS]
    return [random.choice(letters) + "".join(
        random.choice(random.choice(kinds))
        for _ in range(random.randrange(10))) for _ in range(count)]


def characters_of(words):
    """All of the words, and what their letters and marks compose."""
    text = "".join(words)
    return "".join(sorted(set(text + unicodedata.normalize("NFC", text)) |
                          {" "}))


def by_harfbuzz(face, script, *text):
    command = ["hb-shape", "--shaper=ot", f"--script={script}",
               "--no-glyph-names", "--output-format=json", face, *text]
    lines = subprocess.run(command, check=True, capture_output=True,
                           text=True).stdout.splitlines()
    return [[(g["g"], g["cl"], g["dx"], g["dy"], g["ax"])
             for g in json.loads(line)] for line in lines]


def by_device(inspect, font, file):
    lines = subprocess.run([inspect, font, "--run-file", file], check=True,
                           capture_output=True, text=True).stdout.splitlines()
    return [[(g["glyph"], g["cluster"], g["x"], g["y"], g["advance"])
             for g in json.loads(line)] for line in lines]


def is_equal(own, wanted, names):
    """Whether a word is equal. Glyphs are numbered anew in the font, each by
    one number of the file."""
    if len(own) != len(wanted):
        return False
    return all(names.setdefault(a[0], b[0]) == b[0] and a[1:] == b[1:]
               for a, b in zip(own, wanted))


def texts_of(kind, count, lists, names):
    """What is shaped, by its name."""
    if kind == "words":
        return {one: lists[one] for one in names}
    if kind == "sentences":
        return {one: sentences_of(lists[one], count) for one in names}
    words = [word for one in names for word in lists[one]]
    return {"random": random_of(words, count)}


def has_circle(glyphs, circle):
    """Whether HarfBuzz put a dotted circle into a text, which has none: where
    a mark stands on nothing in Devanagari, if the face has one."""
    return circle != 0 and any(glyph[0] == circle for glyph in glyphs)


def main():
    fontgen, inspect, folder = sys.argv[1:4]
    kind = sys.argv[4] if len(sys.argv) > 4 else "words"
    count = (int(sys.argv[5]) if len(sys.argv) > 5 else
             {"words": 5000, "sentences": 1000, "random": 10000}[kind])
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    lists = word_lists(count if kind == "words" else 5000)
    failed = 0
    for number, (name, face, shape, script, names) in enumerate(CASES):
        if kind == "random" and not shape:
            continue  # marks that compose with nothing are not placed
        font = folder / f"{number}.bin"
        texts = texts_of(kind, count, lists, names)
        words = [word for text in texts.values() for word in text]
        chars = folder / f"{number}.txt"
        chars.write_text(characters_of(words), encoding="utf-8")
        subprocess.run([fontgen, "--font", face, "--text-file", chars,
                        *(["--shape", shape] if shape else []), "--out", font,
                        "--min-px", "16", "--max-px", "16"],
                       check=True, capture_output=True)
        ids = {}
        circle = by_harfbuzz(face, script, "--unicodes=25cc")[0][0][0]
        for one, lines in texts.items():
            file = folder / f"{number}_words.txt"
            file.write_text("\n".join(lines) + "\n", encoding="utf-8")
            own = by_device(inspect, font, file)
            wanted = by_harfbuzz(face, script, f"--text-file={file}")
            assert len(own) == len(wanted) == len(lines)
            triples = [(line, a, b) for line, a, b in zip(lines, own, wanted)
                       if not has_circle(b, circle)]
            wrong = [(line, a, b) for line, a, b in triples
                     if not is_equal(a, b, ids)]
            left_out = len(lines) - len(triples)
            print(f"{name}, {one}: {len(triples) - len(wrong)} of "
                  f"{len(triples)} equal" +
                  (f", {left_out} with a dotted circle left out" if left_out
                   else ""))
            for line, a, b in wrong[:3 if kind != "random" else None]:
                codes = " ".join(f"{ord(c):04x}" for c in line)
                print(f"  {line} ({codes})\n    the device {a}\n"
                      f"    HarfBuzz   {b}")
            is_good = (len(wrong) <= len(triples) // 200
                       if kind == "random" else not wrong)
            failed += not is_good
        if len(set(ids.values())) != len(ids):
            print(f"{name}: two glyphs of the font are one of the file")
            failed += 1
    return failed != 0


sys.exit(main())
