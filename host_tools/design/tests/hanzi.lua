-- Glyphs made of strokes like hanzi, always the same ones:
--
--   inkcell-design script hanzi.lua --set count=500 --out Hanzi.ufo
--
-- One pen draws centre lines of common parts in boxes beside, above and inside
-- each other. Most results are no real characters. They have 4 to 16 strokes,
-- and code points spread evenly over the block of hanzi, so that no two are
-- neighbours.

local count = param("count", 500, 1, 500)
local is_rectangle = param("rectangle", 0, 0, 1)   -- the nib's profile
local width = param("width", 60, 20, 120)          -- of the nib [units]
local height = param("height", 40, 20, 120)
local angle = param("angle", 30, -90, 90)          -- how the nib is held
local rise = param("rise", 0.05, 0, 0.2)           -- of horizontal strokes

local least_strokes, most_strokes = 4, 16
local block, code_step = 0x4E00, 41
local hook = 80                                    -- length of a hook [units]

local nib = (is_rectangle == 1 and pen.rectangle or pen.ellipse)(
  width, height, angle)

-- The same numbers on every machine.
local seed = 12345
local function random(low, high)
  seed = (seed * 1103515245 + 12345) % 2147483648
  return low + (seed // 65536) % (high - low + 1)
end
local function one_of(list) return list[random(1, #list)] end

-- Kinds of strokes: from numbers in percent of the part's box to a path. at(x,
-- y) maps them to units; horizontal strokes rise from their start.
local kinds = {}
local function level(at, x1, y, x2)
  local from, to = at(x1, y), at(x2, y)
  to[2] = to[2] + math.floor(rise * (to[1] - from[1]) + 0.5)
  return from, to
end
local function bend(from, to, dir_from, dir_to)
  return curve{{from[1], from[2], dir = dir_from},
               {to[1], to[2], dir = dir_to}}
end
-- The direction from one point to another, turned. [degrees]
local function towards(from, to, by)
  return math.deg(math.atan(to[2] - from[2], to[1] - from[1])) + by
end
local function tip(at_end, dx, dy)
  return lines{at_end, {at_end[1] + dx * hook, at_end[2] + dy * hook}}
end

function kinds.heng(at, x1, y, x2) return lines{level(at, x1, y, x2)} end
function kinds.shu(at, x, y1, y2) return lines{at(x, y1), at(x, y2)} end
function kinds.ti(at, x1, y1, x2, y2) return lines{at(x1, y1), at(x2, y2)} end
function kinds.pie(at, x1, y1, x2, y2)
  local from, to = at(x1, y1), at(x2, y2)
  return bend(from, to, towards(from, to, 18), towards(from, to, -18))
end
function kinds.na(at, x1, y1, x2, y2)
  local from, to = at(x1, y1), at(x2, y2)
  return bend(from, to, towards(from, to, -12), towards(from, to, 16))
end
function kinds.dian(at, x1, y1, x2, y2)
  local from, to = at(x1, y1), at(x2, y2)
  return bend(from, to, towards(from, to, 12), towards(from, to, -12))
end
function kinds.shu_gou(at, x, y1, y2)
  local to = at(x, y2)
  return join(lines{at(x, y1), to}, tip(to, -0.85, 0.5))
end
function kinds.heng_zhe(at, x1, y, x2, y2)
  local from, corner = level(at, x1, y, x2)
  return join(lines{from, corner}, lines{corner, at(x2, y2)})
end
function kinds.heng_zhe_gou(at, x1, y, x2, y2)
  local from, corner = level(at, x1, y, x2)
  local to = at(x2, y2)
  return join(lines{from, corner}, lines{corner, to}, tip(to, -0.85, 0.5))
end
function kinds.heng_pie(at, x1, y1, x2, x3, y3)
  local from, corner = level(at, x1, y1, x2)
  local to = at(x3, y3)
  return join(lines{from, corner},
              bend(corner, to, towards(corner, to, 14),
                   towards(corner, to, -16)))
end
function kinds.shu_zhe(at, x, y1, y2, x2)
  local corner, to = level(at, x, y2, x2)
  return join(lines{at(x, y1), corner}, lines{corner, to})
end
function kinds.pie_zhe(at, x1, y1, x2, y2, x3, y3)
  return lines{at(x1, y1), at(x2, y2), at(x3, y3)}
end
function kinds.shu_wan_gou(at, x1, y1, x2, y2)
  local from, low, to = at(x1, y1), at(x1, y2), at(x2, y2)
  local r = math.min(110, (to[1] - low[1]) / 2, (from[2] - low[2]) / 2)
  return join(lines{from, {low[1], low[2] + r}},
              bend({low[1], low[2] + r}, {low[1] + r, low[2]}, -90, 0),
              lines{{low[1] + r, low[2]}, to}, tip(to, 0.1, 1))
end
function kinds.xie_gou(at, x1, y1, x2, y2)
  local from, to = at(x1, y1), at(x2, y2)
  return join(bend(from, to, towards(from, to, -14), towards(from, to, 22)),
              tip(to, 0.1, 1))
end

-- A part: its strokes, one a line, in percent of its box, y up.
local function part(text)
  local strokes = {}
  for kind, numbers in text:gmatch("([%l_]+)([%s%d-]+)") do
    local stroke = {kind = kind}
    for number in numbers:gmatch("-?%d+") do
      stroke[#stroke + 1] = tonumber(number)
    end
    strokes[#strokes + 1] = stroke
  end
  return strokes
end

-- Named by their readings.
local kou = part "shu 8 92 4 heng_zhe 8 92 92 4 heng 8 10 92"
local ri = part [[shu 14 98 2 heng_zhe 14 98 86 2 heng 14 52 86
  heng 14 8 86]]
local mu_eye = part [[shu 14 98 2 heng_zhe 14 98 86 2 heng 14 68 86
  heng 14 38 86 heng 14 8 86]]
local tian = part [[shu 8 94 4 heng_zhe 8 94 92 4 heng 8 50 92
  shu 50 94 10 heng 8 10 92]]
local shi_ten = part "heng 4 56 96 shu 50 98 2"
local tu = part "heng 14 62 86 shu 50 96 6 heng 4 6 96"
local wang = part "heng 10 92 90 heng 16 50 84 shu 50 92 6 heng 2 6 98"
local gong = part "heng 12 90 88 shu 50 90 8 heng 2 8 98"
local er = part "heng 18 76 82 heng 4 12 96"
local san = part "heng 12 92 88 heng 20 50 80 heng 2 6 98"
local da = part "heng 4 64 96 pie 50 98 4 2 na 52 62 98 2"
local ren = part "pie 52 98 2 4 na 50 66 98 2"
local mu = part [[heng 4 70 96 shu 50 98 2 pie 48 68 4 20
  na 52 68 96 20]]
local he = part [[pie 74 98 22 88 heng 4 64 96 shu 50 88 2
  pie 48 62 4 18 na 52 62 96 18]]
local mi = part [[dian 18 92 34 70 pie 82 94 66 68 heng 4 56 96
  shu 50 98 2 pie 48 54 6 12 na 52 54 96 12]]
local nv = part "pie_zhe 44 98 22 34 88 4 pie 72 66 12 2 heng 2 66 98"
local zi = part "heng_pie 16 92 82 52 62 shu_gou 52 62 4 heng 2 46 98"
local li = part "heng_zhe_gou 8 68 86 4 pie 46 98 4 2"
local dao = part "heng_zhe_gou 8 90 86 6 pie 46 88 4 4"
local you = part "heng_pie 8 90 84 8 2 na 20 78 98 2"
local cun = part "heng 4 68 96 shu_gou 66 98 4 dian 26 48 42 26"
local yue = part [[pie 22 94 4 2 heng_zhe_gou 22 94 84 4
  heng 24 66 84 heng 24 38 84]]
local shi_stone = part [[heng 4 94 96 pie 46 92 4 34 shu 26 52 4
  heng_zhe 26 52 88 4 heng 26 10 88]]
local huo = part "dian 14 74 28 50 pie 86 80 72 54 pie 50 98 4 2 na 52 52 98 2"
local shan = part "shu 50 98 10 shu_zhe 8 66 6 92 shu 92 66 4"
local zhong = part "shu 10 76 32 heng_zhe 10 76 90 32 heng 10 38 90 shu 50 98 2"
local bai = part [[pie 54 98 38 82 shu 14 80 2 heng_zhe 14 80 86 2
  heng 14 44 86 heng 14 8 86]]
local qie = part [[shu 22 94 8 heng_zhe 22 94 78 8 heng 22 66 78
  heng 22 38 78 heng 2 8 98]]
local xin = part [[dian 10 60 2 22 shu_wan_gou 24 76 74 8 dian 44 92 58 66
  dian 80 78 96 44]]
local min = part [[shu 14 88 12 heng_zhe 14 88 86 12 shu 38 88 12
  shu 62 88 12 heng 0 10 100]]
local huo_dots = part [[dian 10 80 2 14 dian 34 78 40 18 dian 60 78 68 18
  dian 84 80 98 14]]
local cao = part "heng 2 50 98 shu 32 98 4 shu 68 98 4"
local mian = part "dian 46 98 56 72 dian 6 60 2 8 heng_pie 6 60 96 86 14"
local tou = part "dian 46 98 54 62 heng 2 24 98"
local zhu = part [[pie 22 98 2 36 heng 16 64 46 dian 28 54 36 18
  pie 66 98 48 36 heng 62 64 98 dian 74 54 82 18]]
local yu_rain = part [[heng 16 96 84 dian 6 70 2 30 heng_pie 6 70 96 88 36
  shu 50 94 4 dian 24 52 36 42 dian 24 30 36 18 dian 62 52 74 42
  dian 62 30 74 18]]
local dan_ren = part "pie 76 98 6 48 shu 52 72 2"
local shui = part "dian 22 96 60 80 dian 8 64 46 50 ti 14 4 84 40"
local shou = part "heng 4 74 94 shu_gou 56 98 4 ti 2 30 96 48"
local yan = part "dian 30 98 52 80 heng_zhe 4 62 52 12 ti 52 12 96 36"
local jin = part [[pie 44 98 4 62 heng 26 80 84 heng 16 54 84
  heng 8 32 90 shu_zhe 50 54 6 50 ti 50 6 96 24]]
local si = part [[pie_zhe 48 98 12 64 62 66 pie_zhe 74 80 8 36 84 40
  ti 4 6 92 20]]
local dao_side = part "shu 22 84 30 shu_gou 80 98 4"
local yi = part "heng_zhe 8 92 72 52 heng 8 52 72 shu_wan_gou 8 92 94 6"
local er_side = part "heng_pie 6 92 66 30 58 heng_pie 30 58 66 24 30 shu 6 92 2"
local ge = part [[heng 2 64 92 xie_gou 36 98 94 8 pie 84 48 24 4
  dian 70 94 88 80]]
local chong = part [[shu 14 84 48 heng_zhe 14 84 86 48 heng 14 50 86
  shu 50 98 10 heng 6 8 94 dian 76 30 96 4]]
local bei = part [[shu 16 96 26 heng_zhe 16 96 84 26 pie 50 80 6 2
  na 56 26 96 2]]

-- The places of parts, and frames with the box for their content.
local left = {dan_ren, shui, shou, yan, jin, si, kou, mu, tu, nv, ri, huo, wang,
              shi_stone, he, mi, yue, mu_eye, zi, shan}
local right = {dao_side, you, cun, li, dao, er_side, qie, mu, ge, bai, zhong,
               da, ren, yi, chong, tian, bei, wang, kou, ri, gong, shi_ten}
local top = {cao, mian, tou, zhu, yu_rain, shan, ri, tian, tu, kou, bai, da}
local bottom = {xin, min, huo_dots, kou, ri, mu, tu, nv, zi, da, bei, er, li,
                shi_ten, mu_eye, you, tian, gong}
local alone = {mu, mi, tian, bai, zhong, chong, bei, shi_stone, mu_eye, yu_rain,
               he, qie}
local frames = {
  {inner = {24, 16, 76, 76}, strokes = part [[shu 2 98 2
    heng_zhe 2 98 98 2 heng 2 6 98]]},                        -- wei
  {inner = {24, 4, 76, 66}, strokes = part [[dian 14 100 24 86 shu 2 80 0
    heng_zhe_gou 34 92 98 2]]},                               -- men
  {inner = {28, 4, 98, 68}, strokes = part [[dian 46 100 56 88 heng 8 82 98
    pie 10 80 0 0]]},                                         -- guang
  {inner = {26, 4, 98, 76}, strokes = part [[heng 8 94 98
    pie 10 92 0 0]]},                                         -- chang
  {inner = {30, 2, 96, 56}, strokes = part [[heng_zhe 14 96 90 70
    heng 16 70 90 pie 14 96 0 0]]},                           -- shi
  {inner = {36, 28, 96, 98}, strokes = part [[dian 8 94 18 80
    heng_pie 2 62 20 10 22 na 8 22 98 2]]},                   -- chuo
  {inner = {24, 4, 76, 72}, strokes = part [[shu 4 96 2
    heng_zhe_gou 4 96 96 2]]},                                -- jiong
}

-- Trees of parts in boxes {left, low, right, high} of the em. [units]
local function place(list, box, strokes)
  for _, s in ipairs(strokes) do
    list[#list + 1] = {kind = s.kind, numbers = s, box = box}
  end
end

local compose
local function inside(list, box, pool, may_divide)
  if may_divide and random(1, 4) < 4 then
    compose(list, box, false)
  else
    place(list, box, one_of(pool))
  end
end

local gap = 110  -- between centre lines of neighbours [units]

function compose(list, box, is_whole)
  local l, b, r, t = table.unpack(box)
  local choice = random(1, 20)
  if choice <= 11 then       -- left and right
    local x = l + (r - l) * random(33, 45) // 100
    inside(list, {l, b, x - gap // 2, t}, left, false)
    inside(list, {x + gap // 2, b, r, t}, right, is_whole)
  elseif choice <= 16 then   -- above and below
    local y = b + (t - b) * random(50, 66) // 100
    inside(list, {l, y + gap // 2, r, t}, top, false)
    inside(list, {l, b, r, y - gap // 2}, bottom, is_whole)
  elseif choice <= 19 and is_whole then
    local frame = one_of(frames)
    local i = frame.inner
    place(list, box, frame.strokes)
    local function x(percent) return l + (r - l) * percent // 100 end
    local function y(percent) return b + (t - b) * percent // 100 end
    inside(list, {x(i[1]), y(i[2]), x(i[3]), y(i[4])}, bottom, true)
  else
    place(list, box, one_of(alone))
  end
end

local function path_of(stroke)
  local l, b, r, t = table.unpack(stroke.box)
  local function at(x, y)
    return {math.floor(l + (r - l) * x / 100 + 0.5),
            math.floor(b + (t - b) * y / 100 + 0.5)}
  end
  return kinds[stroke.kind](at, table.unpack(stroke.numbers))
end

set_info{key = "unitsPerEm", value = 1000}
set_info{key = "ascender", value = 880}
set_info{key = "descender", value = -120}
set_info{key = "familyName", value = "Inkcell Hanzi"}

-- The same parts side by side are one character, whatever the grouping.
local function name_of(list)
  local words = {}
  for i, s in ipairs(list) do
    words[i] = s.kind .. " " .. table.concat(s.numbers, " ")
  end
  return table.concat(words, ";")
end

local made, known = 0, {}
while made < count do
  local list = {}
  local side, low = random(60, 100), random(-60, -30)
  compose(list, {side, low, 1000 - side, random(780, 820)}, true)
  local is_new = not known[name_of(list)]
  known[name_of(list)] = true
  if is_new and #list >= least_strokes and #list <= most_strokes then
    local strokes = {}
    for i, s in ipairs(list) do strokes[i] = stroke(nib, path_of(s)) end
    local code = block + made * code_step
    local name = string.format("uni%04X", code)
    add_glyph{glyph = name, unicodes = {code}, width = 1000}
    set_strokes{glyph = name, strokes = strokes}
    made = made + 1
  end
end
