-- Pens and curves for scripts, in the manner of Metafont.
--
-- A knot is {x, y} with named options: dir [degrees], tension, tension_in,
-- tension_out, curl, and for penstroke() width and angle. A path is a list of
-- cubics {x0, y0, x1, y1, x2, y2, x3, y3}.

local function check(condition, text)
  if not condition then error(text, 0) end
end

local function is_point(p)
  return type(p) == "table" and type(p[1]) == "number" and
    type(p[2]) == "number"
end

local function check_knots(name, knots, least)
  check(type(knots) == "table" and #knots >= least,
        name .. ": give at least " .. least .. " knots, such as {{0, 0}, " ..
        "{100, 50, dir = 90}}")
  for i, knot in ipairs(knots) do
    check(is_point(knot), name .. ": knot " .. i .. " is not {x, y}")
    for _, key in ipairs({"tension", "tension_in", "tension_out"}) do
      check(knot[key] == nil or
              type(knot[key]) == "number" and knot[key] >= 0.75,
            name .. ": knot " .. i .. ": " .. key .. " is at least 0.75")
    end
  end
end

local function check_path(name, path)
  check(type(path) == "table" and type(path[1]) == "table" and
          #path[1] == 8, name .. ": give a path, as curve() makes them")
end

local function atan2(y, x) return (x == 0 and y == 0) and 0 or math.atan(y, x) end

-- Normalises an angle to (-pi, pi].
local function turn(angle)
  return angle - 2 * math.pi * math.ceil(angle / (2 * math.pi) - 0.5)
end

-- Gaussian elimination with pivoting; m has a column more than rows.
local function solve(m)
  local n = #m
  for k = 1, n do
    local best = k
    for r = k + 1, n do
      if math.abs(m[r][k]) > math.abs(m[best][k]) then best = r end
    end
    m[k], m[best] = m[best], m[k]
    for r = k + 1, n do
      local f = m[r][k] / m[k][k]
      if f ~= 0 then
        for c = k, n + 1 do m[r][c] = m[r][c] - f * m[k][c] end
      end
    end
  end
  local x = {}
  for k = n, 1, -1 do
    local sum = m[k][n + 1]
    for c = k + 1, n do sum = sum - m[k][c] * x[c] end
    x[k] = sum / m[k][k]
  end
  return x
end

-- Hobby's velocity (The Metafontbook, chapter 14).
local function velocity(theta, phi)
  local st, sp = math.sin(theta), math.sin(phi)
  local ct, cp = math.cos(theta), math.cos(phi)
  local root = math.sqrt(5)
  return (2 + math.sqrt(2) * (st - sp / 16) * (sp - st / 16) * (ct - cp)) /
    (3 * (1 + (root - 1) / 2 * ct + (3 - root) / 2 * cp))
end

-- Solves knots from `first` to `last` without a direction between them;
-- `wraps`: the last is the first again. Writes the angle of the path at each
-- knot, relative to its chord, into theta (leaving) and phi (arriving).
local function angles(z, first, last, wraps, theta, phi)
  local n = last - first  -- pieces
  local d, chord = {}, {}
  for i = 0, n - 1 do
    local a, b = z[first + i], z[first + i + 1]
    d[i] = math.sqrt((b[1] - a[1]) ^ 2 + (b[2] - a[2]) ^ 2)
    check(d[i] > 0, "curve: two knots beside each other are equal")
    chord[i] = atan2(b[2] - a[2], b[1] - a[1])
  end
  local function out(i) return 1 / (z[first + i].tension_out or
                                    z[first + i].tension or 1) end
  local function into(i) return 1 / (z[first + i].tension_in or
                                     z[first + i].tension or 1) end
  local psi = {[n] = wraps and turn(chord[0] - chord[n - 1]) or 0}
  for i = 1, n - 1 do psi[i] = turn(chord[i] - chord[i - 1]) end
  local count = wraps and n or n + 1
  local m = {}
  for r = 1, count do
    m[r] = {}
    for c = 1, count + 1 do m[r][c] = 0 end
  end
  local function add(row, i, value)  -- of theta at knot i
    local c = i % count + 1
    m[row][c] = m[row][c] + value
  end
  local function inner(i)
    local before, after = (i - 1) % n, i % n
    local row, next_i = i % count + 1, i + 1
    local a_before, b_next = out(before), into(wraps and next_i % n or next_i)
    local a, b = out(i % count), into(i % count)
    local left = 1 / (b * b * d[before])
    local right = 1 / (a * a * d[after])
    add(row, before, a_before * left)
    add(row, i, (3 - a_before) * left + (3 - b_next) * right)
    add(row, next_i, b_next * right)
    local psi_i, psi_next = psi[i == 0 and n or i],
                            psi[wraps and (next_i - 1) % n + 1 or next_i]
    m[row][count + 1] = -(3 - a_before) * left * psi_i - b_next * right * psi_next
  end
  for i = wraps and 0 or 1, n - 1 do inner(i) end
  if not wraps then
    local begin, finish = z[first], z[last]
    if begin.dir then
      m[1][1], m[1][count + 1] = 1, turn(math.rad(begin.dir) - chord[0])
    else
      local a, b = out(0), into(1)
      local chi = a * a * (begin.curl or 1) / (b * b)
      m[1][1] = chi * a + 3 - b
      m[1][2] = m[1][2] + (3 - a) * chi + b
      m[1][count + 1] = -((3 - a) * chi + b) * psi[1]
    end
    if finish.dir then
      m[count][count] = 1
      m[count][count + 1] = turn(math.rad(finish.dir) - chord[n - 1])
    else
      local a, b = out(n - 1), into(n)
      local chi = b * b * (finish.curl or 1) / (a * a)
      m[count][count - 1] = m[count][count - 1] + (3 - b) * chi + a
      m[count][count] = b * chi + 3 - a
    end
  end
  local x = solve(m)
  for i = 0, n - 1 do
    theta[first + i] = x[i + 1]
    phi[first + i + 1] = -psi[i + 1] - x[(i + 1) % count + 1]
  end
end

--- A smooth path through knots (Hobby 1986); `closed = true` in the list closes
--- it. A knot with dir keeps that direction.
function curve(knots)
  check_knots("curve", knots, 2)
  local z = {}
  for i, knot in ipairs(knots) do z[i] = knot end
  if knots.closed then
    -- Begins at a knot with a given direction, if there is one.
    local first = 1
    for i = #knots, 1, -1 do if knots[i].dir then first = i end end
    for i = 1, #knots do z[i] = knots[(first + i - 2) % #knots + 1] end
    z[#knots + 1] = z[1]
  end
  local theta, phi = {}, {}
  local from = 1
  local wraps = knots.closed and not z[1].dir
  for i = 2, #z do
    if i == #z or z[i].dir and not wraps then
      angles(z, from, i, wraps, theta, phi)
      from = i
    end
  end
  local path = {}
  for i = 1, #z - 1 do
    local a, b = z[i], z[i + 1]
    local dx, dy = b[1] - a[1], b[2] - a[2]
    local t, p = theta[i], phi[i + 1]
    local r = velocity(t, p) / (a.tension_out or a.tension or 1)
    local s = velocity(p, t) / (b.tension_in or b.tension or 1)
    local ct, st, cp, sp = math.cos(t), math.sin(t), math.cos(p), math.sin(p)
    path[i] = {a[1], a[2],
               a[1] + r * (dx * ct - dy * st), a[2] + r * (dx * st + dy * ct),
               b[1] - s * (dx * cp + dy * sp), b[2] - s * (dy * cp - dx * sp),
               b[1], b[2]}
  end
  path.knots = z
  return path
end

--- Straight lines from knot to knot.
function lines(knots)
  check_knots("lines", knots, 2)
  local path = {knots = {}}
  local count = #knots
  for i = 1, knots.closed and count or count - 1 do
    local a, b = knots[i], knots[i % count + 1]
    path[i] = {a[1], a[2], (2 * a[1] + b[1]) / 3, (2 * a[2] + b[2]) / 3,
               (a[1] + 2 * b[1]) / 3, (a[2] + 2 * b[2]) / 3, b[1], b[2]}
    path.knots[i], path.knots[i + 1] = a, b
  end
  return path
end

--- Concatenates paths, with a straight line where they do not meet.
function join(...)
  local path = {knots = {}}
  for _, part in ipairs({...}) do
    check_path("join", part)
    local last = path[#path]
    if last and (last[7] ~= part[1][1] or last[8] ~= part[1][2]) then
      path[#path + 1] = lines({{last[7], last[8]},
                               {part[1][1], part[1][2]}})[1]
      path.knots[#path.knots + 1] = part.knots[1]
    end
    for i, piece in ipairs(part) do
      path[#path + 1] = piece
      path.knots[#path] = part.knots[i]
      path.knots[#path + 1] = part.knots[i + 1]
    end
  end
  return path
end

--- The same path in the opposite direction.
function reverse(path)
  check_path("reverse", path)
  local result = {knots = {}}
  for i = #path, 1, -1 do
    local p = path[i]
    result[#result + 1] = {p[7], p[8], p[5], p[6], p[3], p[4], p[1], p[2]}
  end
  for i = #path.knots, 1, -1 do
    result.knots[#result.knots + 1] = path.knots[i]
  end
  return result
end

--- A superellipse, counter-clockwise. superness 0.5 is a diamond, 0.7071 an
--- ellipse, 1 a rectangle.
function superellipse(x, y, half_width, half_height, superness)
  superness = superness or math.sqrt(0.5)
  check(is_point({x, y}) and is_point({half_width, half_height}) and
          type(superness) == "number" and superness >= 0.5 and superness <= 1,
        "superellipse: give x, y, half_width, half_height, and a superness " ..
        "of 0.5 to 1")
  local s = superness
  local diagonal = math.deg(math.atan(half_height, half_width))
  local function knot(dx, dy, dir)
    return {x + dx * half_width, y + dy * half_height, dir = dir}
  end
  return curve({closed = true,
    knot(1, 0, 90), knot(s, s, 180 - diagonal), knot(0, 1, 180),
    knot(-s, s, 180 + diagonal), knot(-1, 0, 270), knot(-s, -s, -diagonal),
    knot(0, -1, 0), knot(s, -s, diagonal)})
end

--- A path as the points of a contour, for add_contour and set_contours.
function contour(path)
  check_path("contour", path)
  local points = {}
  local last = path[#path]
  local closed = math.abs(last[7] - path[1][1]) < 1e-6 and
    math.abs(last[8] - path[1][2]) < 1e-6
  for i, p in ipairs(path) do
    if i == 1 and not closed then points[1] = {p[1], p[2], "line"} end
    points[#points + 1] = {p[3], p[4], "offcurve"}
    points[#points + 1] = {p[5], p[6], "offcurve"}
    points[#points + 1] = {p[7], p[8], "curve"}
  end
  return points
end

--- Pens: the nib of a stroke; its width is along the angle [degrees].
pen = {}
local function nib(kind)
  return function(width, height, angle)
    height, angle = height or width, angle or 0
    check(is_point({width, height}) and type(angle) == "number",
          "pen." .. kind .. ": give width, height and angle")
    return string.format("%s:%.6g,%.6g,%.6g", kind, width, height, angle)
  end
end
pen.ellipse = nib("ellipse")
pen.rectangle = nib("rectangle")

-- Points of a stroke for each piece of a path.
local kPlaces = 16

--- A stroke of a pen along a path, for set_strokes. Width, height and angle of
--- knots change the nib there, and linearly between them.
function stroke(nib_text, path)
  check(type(nib_text) == "string", "stroke: give a pen first")
  check_path("stroke", path)
  local points = {}
  local function add(x, y, knot)
    points[#points + 1] = knot and
      {x, y, knot.width or null, knot.height or null, knot.angle or null} or
      {x, y}
  end
  add(path[1][1], path[1][2], path.knots[1])
  for i, p in ipairs(path) do
    for k = 1, kPlaces do
      local t = k / kPlaces
      local s = 1 - t
      local a, b, c, d = s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t
      add(a * p[1] + b * p[3] + c * p[5] + d * p[7],
          a * p[2] + b * p[4] + c * p[6] + d * p[8],
          k == kPlaces and path.knots[i + 1])
    end
  end
  return {nib = nib_text, points = points}
end

--- Metafont's penpos and penstroke: a contour whose edges run through the left
--- and the right end of a pen of that width and angle at each knot.
function penstroke(knots)
  check_knots("penstroke", knots, 2)
  local sides = {{closed = knots.closed}, {closed = knots.closed}}
  for i, knot in ipairs(knots) do
    check(type(knot.width) == "number" and type(knot.angle) == "number",
          "penstroke: knot " .. i .. " has no width and angle")
    local dx = knot.width / 2 * math.cos(math.rad(knot.angle))
    local dy = knot.width / 2 * math.sin(math.rad(knot.angle))
    for side, sign in ipairs({-1, 1}) do
      sides[side][i] = {knot[1] + sign * dx, knot[2] + sign * dy,
                        dir = knot.dir, tension = knot.tension,
                        tension_in = knot.tension_in,
                        tension_out = knot.tension_out, curl = knot.curl}
    end
  end
  local left, right = curve(sides[1]), reverse(curve(sides[2]))
  if knots.closed then return contour(left), contour(right) end
  return contour(join(left, right))
end
