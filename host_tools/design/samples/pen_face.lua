-- A few letters drawn with a broad pen, with parameters:
--
--   inkcell-design script pen_face.lua --set weight=120 --out Pen.ufo

local weight = param("weight", 80, 10, 200)        -- width of the pen
local contrast = param("contrast", 0.4, 0.1, 1)    -- its height over its width
local angle = param("angle", 30, -90, 90)          -- how it is held
local x_height = param("x_height", 500, 300, 700)
local superness = param("superness", 0.75, 0.6, 0.9)

local nib = pen.ellipse(weight, weight * contrast, angle)
local low = weight * 0.3                           -- the pen's centre
local high = x_height - low
local ascender = x_height + 250
local side = 60 + weight / 2                       -- of a stem, to the edge
local width = 240                                  -- between two stems

local function draw(name, code, advance, ...)
  add_glyph{glyph = name, unicodes = {code}, width = advance}
  set_strokes{glyph = name, strokes = {...}}
end

local function stem(x, from, to)
  return stroke(nib, lines{{x, from}, {x, to}})
end

-- From the stem at x to the next one, and down.
local function arch(x)
  return stroke(nib, join(
    curve{{x, high - 150, dir = 70}, {x + width * 0.6, high, dir = 0},
          {x + width, high - 140, dir = -90}},
    lines{{x + width, high - 140}, {x + width, low}}))
end

local function dot(x, y)
  return {nib = pen.ellipse(weight * 1.1), points = {{x, y}}}
end

-- A bowl that is open at the right: a path to its top, round to the lower right.
local function open_bowl(x, to_top)
  return stroke(nib, join(to_top, curve{
    {x, high, dir = 180}, {x - 150, x_height / 2, dir = -90},
    {x + 10, low, dir = 0}, {x + 140, low + 70, dir = 40}}))
end

set_info{key = "unitsPerEm", value = 1000}
set_info{key = "ascender", value = ascender}
set_info{key = "descender", value = -200}
set_info{key = "familyName", value = "Inkcell Pen"}
add_glyph{glyph = "space", unicodes = {0x20}, width = 260}

draw("i", 0x69, 2 * side, stem(side, low, high), dot(side, high + 160))
draw("l", 0x6C, 2 * side, stem(side, low, ascender))
draw("n", 0x6E, 2 * side + width, stem(side, low, high), arch(side))
draw("m", 0x6D, 2 * side + 2 * width, stem(side, low, high), arch(side),
     arch(side + width))
draw("o", 0x6F, 2 * side + 300,
     stroke(nib, superellipse(side + 150, x_height / 2, 150,
                              x_height / 2 - low, superness)))
local bowl = side + 120
draw("c", 0x63, 2 * side + 220,
     open_bowl(bowl, curve{{bowl + 130, high - 60, dir = 140},
                           {bowl, high, dir = 180}}))
draw("e", 0x65, 2 * side + 240,
     open_bowl(bowl, join(lines{{bowl - 150, x_height / 2},
                                {bowl + 130, x_height / 2}},
                          curve{{bowl + 130, x_height / 2, dir = 90},
                                {bowl, high, dir = 180}})))
draw("k", 0x6B, 2 * side + width, stem(side, low, ascender),
     stroke(nib, lines{{side + width, high}, {side, x_height * 0.4},
                       {side + width + 20, low}}))
draw("I", 0x49, 2 * side, stem(side, low, ascender - 40))
-- u is n rotated by 180 degrees.
add_glyph{glyph = "u", unicodes = {0x75}, width = 2 * side + width}
add_component{glyph = "u", base = "n",
              matrix = {turn = 180, move = {2 * side + width, x_height}}}
-- A tail whose width follows Metafont's penpos.
add_glyph{glyph = "comma", unicodes = {0x2C}, width = 2 * side}
set_contours{glyph = "comma", contours = {
  penstroke{{side, 60, width = weight, angle = 0, dir = -80},
            {side - 10, -40, width = weight * 0.6, angle = 20},
            {side - 50, -120, width = weight * 0.15, angle = 40, dir = -135}}}}
