"""Section SHAP, read as docs/FORMAT.md states it, and text shaped by it."""
import struct
from typing import NamedTuple

from squares import Refused, require

HEADER_BYTES = 30
MAX_INPUT = 15
MARK = 4  # joining types from there on are marks
ANY, ISOLATED, FINAL, MEDIAL, INITIAL = 1, 2, 4, 8, 16
RIGHT_TO_LEFT, JOINS = 1, 2


class Bits:
    """Numbers of a bit stream, which must not leave it."""

    def __init__(self, data, at, rule):
        self.number, self.end = int.from_bytes(data, "little"), 8 * len(data)
        self.at, self.rule = at, rule

    def take(self, width):
        first, self.at = self.at, self.at + width
        require(self.rule, self.at <= self.end)
        return self.number >> first & (1 << width) - 1

    def take_signed(self):
        value = self.take(16)
        return value - (value >> 15 << 16)

    def rows(self, count, *widths):
        return [tuple(map(self.take, widths)) for _ in range(count)]

    def jump(self, at, rule):
        self.at, self.rule = at, rule


class Program(NamedTuple):
    script: str
    language: str
    flags: int
    substitutions: list  # of lookup, mask, whether ZWJ counts
    positions: list


class Rule(NamedTuple):
    before: list  # sets, the nearest first
    input: list
    behind: list
    actions: list  # place, lookup


class Lookup(NamedTuple):
    kind: int
    skip: int
    filter: int
    data: object


class Shaping(NamedTuple):
    steps: int
    scripts: list
    programs: list
    traits: dict  # joining, rank, mark by code point
    compositions: dict
    mirrors: dict
    lookups: list
    sets: list
    rows: list  # class and bits of lookups, by glyph


class Decoder:
    def __init__(self, data, glyph_count):
        require(21, len(data) >= HEADER_BYTES)
        (self.lookups, self.top, self.sets, self.rows, self.compositions,
         self.characters, self.entries, self.glyphs, self.steps,
         self.programs, self.scripts, self.spans, self.properties, self.marks,
         self.mirrors) = struct.unpack_from("<9H6B", data)
        self.bits = Bits(data, 8 * 24, 21)
        widths = [self.bits.take(5) for _ in range(9)]
        (self.glyph_bits, self.rank_bits, self.mark_bits, self.letter_bits,
         self.offset_bits, self.property_bits, self.lookup_bits, self.set_bits,
         self.row_bits) = widths
        limits = (16, 8, 8, 16, 25, 8, 16, 16, 8)
        require(21, all(a <= b for a, b in zip(widths, limits)))
        require(21, self.steps <= 1024 and self.top <= self.lookups)
        require(21, 1 <= self.rows <= 256 and self.glyphs <= glyph_count)
        self.glyph_count = glyph_count

    def glyph(self, value, rule=23):
        require(rule, value < self.glyph_count)
        return value

    def read(self):
        bits = self.bits
        scripts = bits.rows(self.scripts, 21, 21, 8)
        end = 0
        for first, extra, program in scripts:
            require(21, end <= first and first + extra <= 0x10ffff)
            require(21, program < self.programs)
            end = first + extra + 1
        programs = bits.rows(self.programs, 32, 32, 8, 16, 8, 8)
        entries = bits.rows(self.entries, self.lookup_bits, 5, 1)
        require(21, all(lookup < (self.top if mask else 2)
                        for lookup, mask, _ in entries))
        for program in programs:
            require(21, sum(program[3:]) <= self.entries)
        traits = self.read_traits()
        marks = [code for code, in bits.rows(self.marks, 16)]
        compositions = self.read_compositions(marks)
        mirrors = bits.rows(self.mirrors, 16, 16)
        require(21, all(a[0] < b[0] for a, b in zip(mirrors, mirrors[1:])))
        mirrors = dict(mirrors)
        heads = bits.rows(self.lookups, 4, 3, self.set_bits, 16,
                          self.offset_bits)
        sets = bits.rows(self.sets, self.offset_bits)
        glyph_rows = [row for row, in bits.rows(self.glyphs, self.row_bits)]
        require(21, all(row < self.rows for row in glyph_rows))
        rows = bits.rows(self.rows, 2, *[1] * self.top)
        data = bits.at
        sets = [self.read_set(data + offset) for offset, in sets]
        lookups = [self.read_lookup(data, *head) for head in heads]
        return Shaping(
            self.steps, scripts,
            [Program(tag(script), tag(language), flags,
                     entries[first:first + gsub],
                     entries[first + gsub:first + gsub + gpos])
             for script, language, flags, first, gsub, gpos in programs],
            traits, compositions, mirrors, lookups, sets,
            [rows[row] for row in glyph_rows + [0] * (
                self.glyph_count - self.glyphs)])

    def read_traits(self):
        spans = self.bits.rows(self.spans, 21, 16, 16)
        characters = self.bits.rows(self.characters, self.property_bits)
        properties = self.bits.rows(self.properties, 3, self.rank_bits,
                                    self.mark_bits)
        require(21, all(number < self.properties for number, in characters))
        require(21, all(mark <= self.marks for _, _, mark in properties))
        traits, end, total = {}, 0, 0
        for first, count, start in spans:
            require(21, end <= first and count > 0 and start == total)
            require(21, first + count <= 0x110000)
            end, total = first + count, total + count
            require(21, total <= self.characters)
            for i in range(count):
                traits[first + i] = properties[characters[start + i][0]]
        require(21, total == self.characters)
        return traits

    def read_compositions(self, marks):
        rows = self.bits.rows(self.compositions, self.mark_bits,
                              self.letter_bits, self.letter_bits)
        require(21, self.mark_bits + self.letter_bits <= 25)
        keys = [(letter, mark) for mark, letter, _ in rows]
        require(21, keys == sorted(set(keys)))
        require(21, all(1 <= mark <= self.marks for _, mark in keys))
        return {(letter, marks[mark - 1]): composed
                for mark, letter, composed in rows}

    def ascend(self, glyphs, rule=23, repeated=False):
        for a, b in zip(glyphs, glyphs[1:]):
            require(rule, a < b or (repeated and a == b))
        for glyph in glyphs:
            self.glyph(glyph, rule)

    def read_set(self, at):
        bits = self.bits
        bits.jump(at, 22)
        is_list, first = bits.take(1), bits.take(self.glyph_bits)
        if is_list:
            glyphs = [g for g, in bits.rows(first, self.glyph_bits)]
            self.ascend(glyphs, 22)
            return set(glyphs)
        count = bits.take(self.glyph_bits) + 1
        self.glyph(first + count - 1, 22)
        return {first + i for i in range(count) if bits.take(1)}

    def read_lookup(self, data, kind, skip, filtered, count, offset):
        bits = self.bits
        require(23, filtered <= self.sets)
        bits.jump(data + offset, 23)
        require(23, bits.at <= bits.end)
        readers = {1: self.read_single, 2: self.read_multiple,
                   4: self.read_ligatures, 6: self.read_rules,
                   8: self.read_rules, 9: self.read_adjustments,
                   10: self.read_pairs, 11: self.read_cursive,
                   12: self.read_anchors, 13: self.read_anchors,
                   14: self.read_anchors, 15: self.read_rules}
        require(23, kind in readers or (kind == 0 and count == 0))
        return Lookup(kind, skip, filtered,
                      readers[kind](count) if kind in readers else None)

    def read_single(self, count):
        rows = self.bits.rows(count, self.glyph_bits, self.glyph_bits)
        self.ascend([glyph for glyph, _ in rows])
        return {glyph: self.glyph(to) for glyph, to in rows}

    def read_multiple(self, count):
        bits = self.bits
        width = bits.take(5)
        require(23, width <= 25)
        rows = bits.rows(count + 1, self.glyph_bits, width)
        self.ascend([glyph for glyph, _ in rows[:-1]])
        starts = [start for _, start in rows]
        require(23, starts[0] == 0 and all(
            0 <= b - a <= MAX_INPUT for a, b in zip(starts, starts[1:])))
        out = [self.glyph(g) for g, in bits.rows(starts[-1], self.glyph_bits)]
        return {glyph: out[a:b]
                for (glyph, a), b in zip(rows, starts[1:])}

    def read_ligatures(self, count):
        """A ligature, or 0, by the tuple of its glyphs."""
        bits = self.bits
        width = bits.take(5)
        require(23, width <= 25)
        rows = []
        while True:
            rows.append((bits.take(self.glyph_bits),
                         bits.take(self.glyph_bits), bits.take(width)))
            child = rows[-1][2]
            require(23, child == count if len(rows) == 1 else
                    child >= rows[-2][2])
            if child == len(rows) - 1:
                break
            require(23, child >= len(rows))
        tree = {}
        paths = [()] * len(rows)
        first = 0
        for i, end in enumerate([count] + [row[2] for row in rows[1:]]):
            self.ascend([row[0] for row in rows[first:end]])
            for k in range(first, end):
                paths[k] = (paths[i - 1] if i else ()) + (rows[k][0],)
                tree[paths[k]] = self.glyph(rows[k][1])
            first = end
        return tree

    def take_sets(self, count):
        sets = [number for number, in self.bits.rows(count, self.set_bits)]
        require(23, all(number < self.sets for number in sets))
        return sets

    def read_rules(self, count):
        rules = []
        for _ in range(count):
            before, inputs, behind, actions = self.bits.rows(1, 4, 4, 4, 4)[0]
            first = self.take_sets(1)
            before = self.take_sets(before)
            rule = Rule(before, first + self.take_sets(inputs),
                        self.take_sets(behind),
                        self.bits.rows(actions, 4, self.lookup_bits))
            require(23, all(lookup < self.lookups
                            for _, lookup in rule.actions))
            rules.append(rule)
        return rules

    def read_adjustments(self, count):
        bits = self.bits
        bases = [bits.take_signed() for _ in range(3)]
        widths = [bits.take(5) for _ in range(3)]
        require(23, max(widths) <= 16)
        rows = bits.rows(count, self.glyph_bits, *widths)
        self.ascend([row[0] for row in rows])
        return {row[0]: [base + value for base, value in
                         zip(bases, row[1:])] for row in rows}

    def read_pairs(self, count):
        """Whether x moves too, and advances by pairs of glyphs."""
        bits = self.bits
        base = bits.take_signed()
        left_bits, right_bits, start_bits, value_bits, moves_both = [
            bits.take(5) for _ in range(5)]
        lefts = bits.take(16)
        require(23, max(value_bits, left_bits, right_bits) <= 16)
        require(23, start_bits <= 25)
        members = bits.rows(count, self.glyph_bits, left_bits, right_bits)
        self.ascend([member[0] for member in members])
        require(23, all(left <= lefts for _, left, _ in members))
        starts = [s for s, in bits.rows(lefts + 1, start_bits)]
        require(23, starts[0] == 0 and starts == sorted(starts))
        pairs = bits.rows(starts[-1], right_bits, value_bits)
        values = {}
        for left, (begin, end) in enumerate(zip(starts, starts[1:]), 1):
            rights = [right for right, _ in pairs[begin:end]]
            require(23, [0, *rights] == sorted({0, *rights}))
            for right, value in pairs[begin:end]:
                values[left, right] = base + value
        return moves_both, {glyph: (left, right)
                            for glyph, left, right in members}, values

    def read_cursive(self, count):
        return self.bits.take_signed(), *self.read_anchors(count, 1)

    def read_anchors(self, count, more=0):
        """Anchors of each mark, and rows of anchors of each base, by kind."""
        bits = self.bits
        widths = [bits.take(5) for _ in range(6 + more)]
        level_bits, x_bits, kind_bits, y_bits, pool_bits, count_bits = (
            widths[:6])
        require(23, max(level_bits, x_bits, count_bits) <= 16)
        require(23, pool_bits <= 25 and kind_bits + y_bits <= 25)
        levels, bases = bits.take(16), bits.take(16)
        marks = bits.rows(count, self.glyph_bits, level_bits, x_bits)
        rows = bits.rows(bases, self.glyph_bits, pool_bits, count_bits)
        self.ascend([row[0] for row in marks], repeated=True)
        self.ascend([row[0] for row in rows], repeated=True)
        levels = bits.rows(levels, kind_bits, y_bits)
        pool = bits.rows(max((a + b for _, a, b in rows), default=0),
                         level_bits, x_bits)
        of_marks, of_bases = {}, {}

        def place(level, x):
            require(23, level < len(levels))
            return levels[level][0], (x, levels[level][1])

        for glyph, level, x in marks:
            of_marks.setdefault(glyph, []).append(place(level, x))
        pool = [place(level, x) for level, x in pool]
        for glyph, first, length in rows:
            of_bases.setdefault(glyph, []).append(
                dict(reversed(pool[first:first + length])))
        return of_marks, of_bases, widths[6:]


def tag(number):
    return number.to_bytes(4, "little").decode("ascii", "replace")


def read_shaping(data, glyph_count):
    """Section SHAP of a font. Raises Refused."""
    return Decoder(data, glyph_count).read()


class Glyph:
    def __init__(self, code, form=ANY):
        self.code, self.form, self.glyph, self.kind = code, form, 0, 0
        self.advance = self.x = self.y = self.link = 0
        self.ligature, self.letter, self.letters = 0, 0, 1
        self.part = None  # of what one glyph became


class Run:
    """Shapes one run. Without what shows nothing, such as ZWJ; a letter that is
    composed is not taken apart."""

    def __init__(self, shaping, glyph_of, advances, text):
        self.tables, self.advances = shaping, advances
        self.ligatures = 0
        codes = [ord(c) for c in text]
        self.program = self.find_program(codes)
        if self.program.flags & RIGHT_TO_LEFT:
            codes = [shaping.mirrors.get(code, code) for code in codes]
        codes = self.compose(self.order(codes))
        self.glyphs = [Glyph(code) for code in codes]
        if self.program.flags & JOINS:
            self.join()
        for glyph in self.glyphs:
            self.set(glyph, glyph_of.get(glyph.code, 0))
        self.run(self.program.substitutions)
        for glyph in self.glyphs:
            glyph.advance = advances[glyph.glyph]
        self.run(self.program.positions)
        self.finish()

    def traits(self, code):
        return self.tables.traits.get(code, (0, 0, 0))

    def find_program(self, codes):
        for code in codes:
            for first, extra, program in self.tables.scripts:
                if first <= code <= first + extra:
                    return self.tables.programs[program]
        return Program("", "", 0, [], [])

    def order(self, codes):
        out, marks = [], []
        for code in [*codes, None]:
            if code is not None and self.traits(code)[1]:
                marks.append(code)
                continue
            out += sorted(marks, key=lambda mark: self.traits(mark)[1])
            marks = []
            out.append(code)
        return out[:-1]

    def compose(self, codes):
        out, starter = codes[:1], 0
        for code in codes[1:]:
            rank = self.traits(code)[1]
            is_near = (starter == len(out) - 1 or
                       self.traits(out[-1])[1] < rank)
            composed = self.tables.compositions.get((out[starter], code))
            if is_near and composed:
                out[starter] = composed
                continue
            if not rank:
                starter = len(out)
            out.append(code)
        return out

    def join(self):
        last = None
        for glyph in self.glyphs:
            kind = self.traits(glyph.code)[0]
            if kind >= MARK:
                continue
            takes = kind in (1, 2)
            joined = (last is not None and takes and
                      self.traits(last.code)[0] in (2, 3))
            if joined:
                last.form = ANY | (
                    MEDIAL if last.form & FINAL else INITIAL)
            if kind:
                glyph.form = ANY | (FINAL if joined else ISOLATED)
            last = glyph

    def set(self, glyph, number):
        glyph.glyph = number
        glyph.kind = self.tables.rows[number][0]

    def run(self, entries):
        for number, mask, _ in entries:
            self.mask = mask
            i = 0
            while i < len(self.glyphs):
                glyph = self.glyphs[i]
                length = len(self.glyphs)
                end = None
                if (glyph.form & mask and
                        self.tables.rows[glyph.glyph][1 + number]):
                    end = self.apply(number, i)
                if end is None or (end <= i and len(self.glyphs) >= length):
                    end = i + 1
                i = end

    def skips(self, lookup, glyph):
        if glyph.kind and lookup.skip >> glyph.kind - 1 & 1:
            return True
        return (glyph.kind == 3 and lookup.filter != 0 and
                glyph.glyph not in self.tables.sets[lookup.filter - 1])

    def next(self, lookup, i, step=1):
        i += step
        while 0 <= i < len(self.glyphs):
            if not self.skips(lookup, self.glyphs[i]):
                return i
            i += step
        return None

    def apply(self, number, i):
        """Where the lookup ended; None: it does not apply."""
        lookup = self.tables.lookups[number]
        return {1: self.single, 2: self.multiple, 4: self.ligate,
                6: self.context, 9: self.adjust, 10: self.kern,
                12: self.attach, 13: self.attach, 14: self.attach,
                15: self.context}[lookup.kind](lookup, i)

    def single(self, lookup, i):
        to = lookup.data.get(self.glyphs[i].glyph)
        if to is None:
            return None
        self.set(self.glyphs[i], to)
        return i + 1

    def multiple(self, lookup, i):
        to = lookup.data.get(self.glyphs[i].glyph)
        if to is None:
            return None
        new = []
        for part, number in enumerate(to):
            glyph = Glyph(self.glyphs[i].code, self.glyphs[i].form)
            self.set(glyph, number)
            glyph.part = part if len(to) > 1 else None
            new.append(glyph)
        self.glyphs[i:i + 1] = new
        return i + len(to)

    def ligate(self, lookup, i):
        path, places, best = (self.glyphs[i].glyph,), [i], None
        if path not in lookup.data:
            return None
        first = self.glyphs[i]
        j = i
        while True:
            j = self.next(lookup, j)
            if j is None or not self.glyphs[j].form & self.mask:
                break
            glyph = self.glyphs[j]
            path += (glyph.glyph,)
            if path not in lookup.data or self.apart(first, glyph):
                break
            places.append(j)
            if lookup.data[path]:
                best = list(places), lookup.data[path]
        if best is None:
            return None
        self.join_letters(*best)
        return i + 1

    @staticmethod
    def apart(first, glyph):
        if first.ligature and first.letter:
            return (first.ligature, first.letter) != (glyph.ligature,
                                                      glyph.letter)
        return bool(glyph.ligature and glyph.letter and
                    glyph.ligature != first.ligature)

    def join_letters(self, places, number):
        glyphs = [self.glyphs[place] for place in places]
        rest = all(glyph.kind == 3 for glyph in glyphs[1:])
        is_ligature = not (rest and glyphs[0].kind in (1, 3))
        if is_ligature:
            self.ligatures += 1
            total = 0
            for k, glyph in enumerate(glyphs):
                end = (places[k + 1] if k + 1 < len(places) else
                       len(self.glyphs))
                for i in range(places[k] + 1, end):
                    mark = self.glyphs[i]
                    last = k + 1 == len(places)
                    if last and not (glyph.ligature and mark.letter and
                                     mark.ligature == glyph.ligature):
                        break
                    within = min(mark.letter or glyph.letters, glyph.letters)
                    mark.ligature, mark.letter = self.ligatures, total + within
                total += glyph.letters
            glyphs[0].ligature = self.ligatures
            glyphs[0].letter, glyphs[0].letters = 0, total
        self.set(glyphs[0], number)
        for place in reversed(places[1:]):
            del self.glyphs[place]

    def matches(self, lookup, sets, i, step):
        places = []
        for number in sets:
            i = self.next(lookup, i, step)
            if i is None or (self.glyphs[i].glyph not in
                             self.tables.sets[number]):
                return None
            places.append(i)
        return places

    def context(self, lookup, i):
        sets = self.tables.sets
        for rule in lookup.data:
            if self.glyphs[i].glyph not in sets[rule.input[0]]:
                continue
            rest = self.matches(lookup, rule.input[1:], i, 1)
            if rest is None or any(not self.glyphs[place].form & self.mask
                                   for place in rest):
                continue
            places = [i, *rest]
            if (self.matches(lookup, rule.before, i, -1) is None or
                    self.matches(lookup, rule.behind, places[-1], 1) is None):
                continue
            return self.act(rule, places)
        return None

    def act(self, rule, places):
        glyphs = [self.glyphs[place] for place in places]
        end = places[-1] + 1
        for place, number in rule.actions:
            if place >= len(glyphs) or glyphs[place] not in self.glyphs:
                continue
            at, length = self.glyphs.index(glyphs[place]), len(self.glyphs)
            if self.apply(number, at) is None:
                continue
            change = len(self.glyphs) - length
            end = max(end + change, at)
            if change >= 0:
                glyphs[place:place + 1] = self.glyphs[at:at + 1 + change]
            else:
                glyphs = [glyph for glyph in glyphs if glyph in self.glyphs]
        return end

    def adjust(self, lookup, i):
        glyph = self.glyphs[i]
        if glyph.glyph not in lookup.data:
            return None
        x, y, advance = lookup.data[glyph.glyph]
        glyph.x, glyph.y = glyph.x + x, glyph.y + y
        glyph.advance += advance
        return i + 1

    def kern(self, lookup, i):
        moves_both, classes, values = lookup.data
        j = self.next(lookup, i)
        if j is None:
            return None
        left = classes.get(self.glyphs[i].glyph, (0, 0))[0]
        right = classes.get(self.glyphs[j].glyph, (0, 0))[1]
        if left == 0 or (left, right) not in values:
            return None
        self.glyphs[i].advance += values[left, right]
        self.glyphs[i].x += values[left, right] * moves_both
        return j

    def find_base(self, lookup, i):
        glyphs = self.glyphs
        if lookup.kind == 14:
            j = self.next(lookup, i, -1)
            if j is None or glyphs[j].kind != 3:
                return None
            a, b = glyphs[i], glyphs[j]
            if a.ligature == b.ligature:
                fits = a.ligature == 0 or a.letter == b.letter
            else:
                fits = ((a.ligature and not a.letter) or
                        (b.ligature and not b.letter))
            return j if fits else None
        for j in range(i - 1, -1, -1):
            goes_on = (lookup.kind == 12 and glyphs[j].part and j and
                       glyphs[j - 1].kind != 3 and
                       glyphs[j - 1].part == glyphs[j].part - 1)
            if glyphs[j].kind != 3 and not goes_on:
                return j
        return None

    def attach(self, lookup, i):
        marks, bases, _ = lookup.data
        glyph, j = self.glyphs[i], self.find_base(lookup, i)
        if j is None:
            return None
        base = self.glyphs[j]
        rows = bases.get(base.glyph, [])
        if not rows:
            return None
        row = rows[0]
        if lookup.kind == 13:
            own = base.ligature and base.ligature == glyph.ligature
            row = rows[min(glyph.letter - 1, len(rows) - 1)
                       if own and glyph.letter else -1]
        for kind, (x, y) in marks.get(glyph.glyph, []):
            if kind in row:
                glyph.x, glyph.y = row[kind][0] - x, row[kind][1] - y
                glyph.link = base
                return i + 1
        return None

    def finish(self):
        sign = -1
        if self.program.flags & RIGHT_TO_LEFT:
            sign = 1
        for glyph in self.glyphs:
            glyph.advance = 0 if glyph.kind == 3 else glyph.advance
        for i, glyph in enumerate(self.glyphs):
            if glyph.link == 0:
                continue
            j = self.glyphs.index(glyph.link)
            glyph.x += glyph.link.x + sign * sum(
                other.advance for other in (
                    self.glyphs[j + 1:i + 1] if sign == 1 else
                    self.glyphs[j:i]))
            glyph.y += glyph.link.y
        if sign == 1:
            self.glyphs.reverse()


def shape(shaping, glyph_of, advances, text):
    """Glyph, x, y and advance of each glyph, in visual order."""
    return [(glyph.glyph, glyph.x, glyph.y, glyph.advance)
            for glyph in Run(shaping, glyph_of, advances, text).glyphs]


__all__ = ["Refused", "read_shaping", "shape"]
