// Draws bodies and what links them, as app/ui/scene/layers does in the window. A scene is what scene.js makes for one
// picture: `pen` (the canvas), `camera`, `colors`, `part` (the frames with the same bodies) and `i` (the frame in it).

const fewBodies = 60; // more are drawn with less care
const smallestFace = 12; // px of the screen: smaller bodies have no eyes

function at(scene, point) {
    return scene.camera.at(scene.part.x[point][scene.i] + scene.shiftX, scene.part.y[point][scene.i] + scene.shiftY);
}

function isSeen(scene, place, reach) {
    const { width, height } = scene.camera;
    return place.x > -reach && place.x < width + reach && place.y > -reach && place.y < height + reach;
}

/** The radius of the disc of a point; 0 if it is not drawn. */
function discRadius(scene, point) {
    const body = scene.part.view.bodies[point];
    return body.shape === "none" ? 0 : scene.camera.radius(body.radius);
}

function line(pen, from, to) {
    pen.beginPath();
    pen.moveTo(from.x, from.y);
    pen.lineTo(to.x, to.y);
    pen.stroke();
}

function disc(pen, x, y, radius) {
    pen.beginPath();
    pen.arc(x, y, radius, 0, 2 * Math.PI);
    pen.fill();
}

function useStroke(pen, color, width, dash = []) {
    pen.strokeStyle = color;
    pen.lineWidth = width;
    pen.setLineDash(dash);
    pen.lineCap = dash.length ? "butt" : "round";
    pen.lineJoin = "round";
}

function parts(color) {
    return [1, 3, 5].map((k) => parseInt(color.slice(k, k + 2), 16));
}

/** Returns a colour between two colours of the form #rrggbb. */
function mixed(from, to, share) {
    const target = parts(to);
    const channel = (value, k) => Math.round(value + share * (target[k] - value)).toString(16).padStart(2, "0");
    return "#" + parts(from).map(channel).join("");
}

const fadedColors = new Map();

function faded(color, alpha) {
    const name = color + alpha;
    let found = fadedColors.get(name);
    if (!found) {
        if (fadedColors.size > 2000)
            fadedColors.clear();
        found = `rgba(${parts(color).join(",")},${alpha})`;
        fadedColors.set(name, found);
    }
    return found;
}

/** Draws with a picture that is painted once for each size: gradients take long. */
function stamp(scene, key, half, paint) {
    const ratio = scene.ratio;
    const name = `${key} ${half.toFixed(2)}`;
    let picture = scene.stamps.get(name);
    if (!picture) {
        if (scene.stamps.size > 400)
            scene.stamps.clear();
        picture = document.createElement("canvas");
        picture.width = picture.height = Math.ceil(2 * half * ratio) + 2;
        const pen = picture.getContext("2d");
        pen.scale(ratio, ratio);
        pen.translate(picture.width / 2 / ratio, picture.height / 2 / ratio);
        paint(pen);
        scene.stamps.set(name, picture);
    }
    return picture;
}

function put(scene, picture, x, y, across = 1, down = 1) {
    const width = picture.width / scene.ratio * across;
    const height = picture.height / scene.ratio * down;
    scene.pen.drawImage(picture, x - width / 2, y - height / 2, width, height);
}

/** Draws a disc of one colour. In a crowd it is a copy of a picture, which is quicker and a little less sharp. */
function putDot(scene, color, x, y, radius) {
    if (scene.part.view.bodies.length <= fewBodies || radius > 20) {
        scene.pen.fillStyle = color;
        disc(scene.pen, x, y, radius);
        return;
    }
    put(scene, stamp(scene, color, radius, (pen) => {
        pen.fillStyle = color;
        disc(pen, 0, 0, radius);
    }), x, y);
}

function drawDisc(scene, x, y, radius) {
    const body = scene.colors.body;
    if (radius < 5 || radius > 200) { // too small for a gradient, or too large to keep
        scene.pen.fillStyle = body;
        disc(scene.pen, x, y, radius);
        return;
    }
    put(scene, stamp(scene, "disc", radius, (pen) => {
        const light = pen.createRadialGradient(-0.22 * radius, -0.34 * radius, 0, -0.22 * radius, -0.34 * radius,
                                               1.38 * radius);
        light.addColorStop(0, mixed(body, "#ffffff", 0.2));
        light.addColorStop(0.22, body);
        light.addColorStop(0.55, body);
        light.addColorStop(1, mixed(body, "#000000", 0.28));
        pen.fillStyle = light;
        disc(pen, 0, 0, radius);
    }), x, y);
}

function drawShade(scene, x, y, across, down, strength) {
    const half = 64;
    const picture = stamp(scene, "shade", half, (pen) => {
        const shade = pen.createRadialGradient(0, 0, 0, 0, 0, half);
        shade.addColorStop(0, "rgba(0,0,0,1)");
        shade.addColorStop(0.55, "rgba(0,0,0,0.55)");
        shade.addColorStop(1, "rgba(0,0,0,0)");
        pen.fillStyle = shade;
        disc(pen, 0, 0, half);
    });
    scene.pen.globalAlpha = strength;
    put(scene, picture, x, y, across / half, down / half);
    scene.pen.globalAlpha = 1;
}

function drawShadows(scene) {
    const { part, i, camera } = scene;
    const { room, ground, dusk, bodies } = part.view;
    if (bodies.length > 300 || dusk)
        return;
    const full = scene.isDark ? 0.6 : 0.26;
    bodies.forEach((body, point) => {
        if ((body.shape !== "body" && body.shape !== "foot") || body.radius * camera.zoom < 4)
            return;
        const place = at(scene, point);
        const drawn = camera.radius(body.radius);
        if (!isSeen(scene, place, 200 + 2 * drawn))
            return;
        if (!room && ground === undefined) {
            drawShade(scene, place.x, place.y + 0.16 * drawn + 1, 1.32 * drawn, 1.32 * drawn, Math.min(1, 1.15 * full));
            return;
        }
        const x = part.x[point][i];
        const inside = room && x > (room.left ?? -Infinity) && x < (room.right ?? Infinity);
        if (room && !inside)
            return;
        const floor = room ? room.floor : ground;
        const y = part.y[point][i];
        const height = Math.max(0, floor - y - body.radius);
        if (height >= 160 || y - body.radius > floor)
            return;
        const share = height / 160;
        const across = camera.zoom * body.radius * (1.1 + share);
        const down = 0.17 * across;
        drawShade(scene, place.x, Math.round(camera.at(0, floor + scene.shiftY).y) + down + 1, across, down,
                  full * (1 - share) ** 2);
    });
}

/** Draws a leg, thick at the body and thin at the foot. */
function drawLeg(scene, leg, width) {
    const body = at(scene, leg.from);
    const foot = at(scene, leg.to);
    const isCurved = leg.curve !== 0;
    const bend = isCurved ? { x: foot.x, y: foot.y - leg.curve * scene.camera.zoom }
                          : { x: (body.x + foot.x) / 2, y: (body.y + foot.y) / 2 };
    const pieces = isCurved ? 16 : 1;
    const sides = [[], []];
    let across = { x: 0, y: 1 };
    for (let k = 0; k <= pieces; ++k) {
        const t = k / pieces;
        const on = (axis) => (1 - t) ** 2 * body[axis] + 2 * t * (1 - t) * bend[axis] + t ** 2 * foot[axis];
        const way = (axis) => (1 - t) * (bend[axis] - body[axis]) + t * (foot[axis] - bend[axis]);
        const length = Math.hypot(way("x"), way("y"));
        if (length > 0)
            across = { x: -way("y") / length, y: way("x") / length };
        const half = 0.5 * width * (1.9 - 0.9 * t);
        sides[0].push([on("x") + half * across.x, on("y") + half * across.y]);
        sides[1].unshift([on("x") - half * across.x, on("y") - half * across.y]);
    }
    fillPolygon(scene.pen, [...sides[0], ...sides[1]]);
}

function fillPolygon(pen, corners) {
    pen.beginPath();
    corners.forEach(([x, y], k) => (k === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
    pen.closePath();
    pen.fill();
}

function drawLegs(scene) {
    const { legs, bodies } = scene.part.view;
    const pen = scene.pen;
    const width = Math.min(6, Math.max(1.5, 3 * Math.sqrt(scene.camera.zoom / 2.6)));
    if (bodies.length <= 600 && width >= 2) {
        pen.fillStyle = mixed(scene.colors.body, scene.colors.scene, 0.15);
        legs.forEach((leg) => drawLeg(scene, leg, width));
        return;
    }
    useStroke(pen, faded(scene.colors.body, 0.85), Math.min(width, Math.max(0.6, scene.camera.zoom)));
    pen.lineCap = "butt";
    pen.beginPath();
    for (const leg of legs) {
        const foot = at(scene, leg.to);
        const body = at(scene, leg.from);
        pen.moveTo(foot.x, foot.y);
        pen.quadraticCurveTo(leg.curve ? foot.x : (foot.x + body.x) / 2,
                             leg.curve ? foot.y - leg.curve * scene.camera.zoom : (foot.y + body.y) / 2, body.x, body.y);
    }
    pen.stroke();
}

/** Draws a zigzag with straight ends; the strands behind are paler. */
function drawCoil(scene, from, to, turns, wide, front, back) {
    const pen = scene.pen;
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    const u = { x: (to.x - from.x) / length, y: (to.y - from.y) / length };
    const lead = Math.min(12, 0.12 * length);
    const piece = (length - 2 * lead) / (2 * turns);
    const along = (way, side) => ({ x: from.x + way * u.x - side * u.y, y: from.y + way * u.y + side * u.x });
    const corner = (k) => along(lead + (k + 0.5) * piece, k % 2 === 0 ? wide : -wide);
    const last = 2 * turns - 1;
    for (const [color, first] of [[back, 2], [front, 1]]) {
        pen.strokeStyle = color;
        pen.beginPath();
        for (let k = first; k <= last; k += 2) {
            const before = corner(k - 1);
            const here = corner(k);
            pen.moveTo(before.x, before.y);
            pen.lineTo(here.x, here.y);
        }
        if (color === front) {
            for (const strand of [[from, along(lead, 0), corner(0)], [corner(last), along(length - lead, 0), to]]) {
                pen.moveTo(strand[0].x, strand[0].y);
                pen.lineTo(strand[1].x, strand[1].y);
                pen.lineTo(strand[2].x, strand[2].y);
            }
        }
        pen.stroke();
    }
}

function endOf(scene, spring) {
    const [x, y] = spring.at;
    return spring.b < 0 ? scene.camera.at(x + scene.shiftX, y + scene.shiftY)
                        : scene.camera.at(scene.part.x[spring.b][scene.i] + x + scene.shiftX,
                                          scene.part.y[spring.b][scene.i] + y + scene.shiftY);
}

function drawSpring(scene, spring, front, back) {
    const { camera, pen } = scene;
    let from = at(scene, spring.a);
    const end = endOf(scene, spring);
    let to = end;
    const isPlace = spring.b < 0 || spring.at[0] !== 0 || spring.at[1] !== 0;
    const near = discRadius(scene, spring.a);
    const far = isPlace ? 3.5 : discRadius(scene, spring.b);
    let length = Math.hypot(to.x - from.x, to.y - from.y);
    const isHidden = isPlace && length <= near;
    if (length > near + far + 5) {
        const u = { x: (to.x - from.x) / length, y: (to.y - from.y) / length };
        from = { x: from.x + near * u.x, y: from.y + near * u.y };
        to = { x: to.x - far * u.x, y: to.y - far * u.y };
        length -= near + far;
    }
    pen.strokeStyle = front;
    if (!isHidden && length < 15) {
        line(pen, from, to);
    } else if (!isHidden) {
        const turns = spring.length > 0 ? Math.min(14, Math.max(3, Math.trunc(spring.length / 9))) : 14;
        const rest = (spring.length > 0 ? spring.length : 9 * turns) * camera.zoom;
        const swelling = Math.min(1.3, Math.max(0.5, Math.sqrt(rest / length)));
        drawCoil(scene, from, to, turns, Math.min(7.5, Math.max(2, 4 * camera.zoom)) * swelling, front, back);
    }
    if (isPlace) {
        pen.beginPath();
        pen.arc(end.x, end.y, 3.5, 0, 2 * Math.PI);
        pen.stroke();
    }
}

function drawSprings(scene) {
    const { springs, bodies } = scene.part.view;
    const { pen, colors, camera } = scene;
    if (springs.length === 0)
        return;
    const areMany = springs.length > 200 || bodies.length > 600;
    for (const isInside of [true, false]) {
        useStroke(pen, faded(colors.spring, isInside ? 0.4 : 1),
                  isInside ? 1 : Math.min(2.4, Math.max(1, 1.1 * camera.zoom)));
        for (const spring of springs) { // one by one: a browser takes long for one path of all
            if ((spring.part === "inside") === isInside && (spring.part !== "alone" || areMany))
                line(pen, at(scene, spring.a), endOf(scene, spring));
        }
    }
    if (areMany)
        return;
    useStroke(pen, colors.spring, Math.min(2, Math.max(1, 1.1 * camera.zoom)));
    const back = mixed(colors.spring, colors.scene, 0.35);
    springs.filter((one) => one.part === "alone").forEach((one) => drawSpring(scene, one, colors.spring, back));
}

function drawSheets(scene) {
    scene.pen.fillStyle = faded(scene.colors.spring, 0.16);
    scene.pen.beginPath();
    for (const corners of scene.part.view.sheets) {
        corners.forEach((point, k) => {
            const { x, y } = at(scene, point);
            k === 0 ? scene.pen.moveTo(x, y) : scene.pen.lineTo(x, y);
        });
        scene.pen.closePath();
    }
    scene.pen.fill();
}

/** The colour and the width of a stick show how wrong its length is. */
function drawStick(scene, stick) {
    const { part, i, colors, camera, pen } = scene;
    const from = at(scene, stick.a);
    const to = at(scene, stick.b);
    const real = Math.hypot(part.x[stick.b][i] - part.x[stick.a][i], part.y[stick.b][i] - part.y[stick.a][i]);
    const strain = stick.length > 0 ? (real - stick.length) / stick.length : 0;
    const bad = Math.min(1, Math.max(0, (Math.abs(strain) - 0.01) / 0.19));
    const color = bad < 0.5 ? mixed(colors.stick, colors.near, 2 * bad) : mixed(colors.near, colors.past, 2 * bad - 1);
    const width = Math.max(1.2, stick.width * (1 + bad * ((strain > 0 ? 0.5 : 1.7) - 1)) * camera.zoom);
    useStroke(pen, color, width);
    line(pen, from, to);
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    if (length === 0)
        return;
    const u = { x: (to.x - from.x) / length, y: (to.y - from.y) / length };
    if (width >= 5) {
        const side = u.x > 0 || (u.x === 0 && u.y > 0) ? 1 : -1;
        const up = { x: side * u.y * 0.24 * width, y: -side * u.x * 0.24 * width };
        useStroke(pen, mixed(color, "#ffffff", 0.4), 0.2 * width);
        line(pen, { x: from.x + up.x, y: from.y + up.y }, { x: to.x + up.x, y: to.y + up.y });
    }
    useStroke(pen, colors.stick, Math.min(4, Math.max(1.2, 0.6 * width)));
    for (const [end, point, way] of [[from, stick.a, 1], [to, stick.b, -1]]) {
        const away = discRadius(scene, point) + 2 + width / 2;
        if (2 * away > length)
            continue;
        const middle = { x: end.x + way * away * u.x, y: end.y + way * away * u.y };
        const half = width + 2;
        line(pen, { x: middle.x - half * u.y, y: middle.y + half * u.x },
             { x: middle.x + half * u.y, y: middle.y - half * u.x });
    }
}

function drawLimbs(scene) {
    for (const limb of scene.part.view.limbs) {
        useStroke(scene.pen, scene.colors.body, Math.max(1.2, limb.width * scene.camera.zoom));
        line(scene.pen, at(scene, limb.a), at(scene, limb.b));
    }
}

function drawRuleLinks(scene) {
    const links = scene.part.view.ruleLinks;
    useStroke(scene.pen, faded(scene.colors.rule, links.length < 60 ? 0.75 : 0.3), 1.2, [8, 4, 1, 4]);
    for (const link of links)
        line(scene.pen, at(scene, link.a), at(scene, link.b));
}

/** Points on the smooth curve through the points of a chain (Catmull and Rom). */
function curveThrough(places) {
    const on = (a, b, c, d, t) => 0.5 * (2 * b + t * (c - a) + t * t * (2 * a - 5 * b + 4 * c - d) +
                                        t * t * t * (3 * b - a - 3 * c + d));
    const last = places.length - 1;
    const place = (k) => places[Math.min(last, Math.max(0, k))];
    const curve = [];
    for (let k = 0; k < last; ++k) {
        for (let piece = 0; piece < 8; ++piece) {
            const [a, b, c, d] = [place(k - 1), place(k), place(k + 1), place(k + 2)];
            curve.push({ x: on(a.x, b.x, c.x, d.x, piece / 8), y: on(a.y, b.y, c.y, d.y, piece / 8) });
        }
    }
    curve.push(places[last]);
    return curve;
}

/** Returns the outline of a chain that gets thinner from its root to its tip. */
function chainPath(scene, chain) {
    const middle = curveThrough(chain.points.map((point) => at(scene, point)));
    const root = chain.width * scene.camera.zoom / 2;
    const half = (k) => Math.max(0.5, root * (1 - 0.82 * k / Math.max(1, middle.length - 1)));
    const sides = [[], []];
    let along = { x: 0, y: 1 };
    middle.forEach((place, k) => {
        const next = middle[Math.min(k + 1, middle.length - 1)];
        const before = middle[Math.max(k - 1, 0)];
        const length = Math.hypot(next.x - before.x, next.y - before.y);
        if (length > 1e-9)
            along = { x: (next.x - before.x) / length, y: (next.y - before.y) / length };
        sides[0].push([place.x + half(k) * along.y, place.y - half(k) * along.x]);
        sides[1].unshift([place.x - half(k) * along.y, place.y + half(k) * along.x]);
    });
    const path = new Path2D();
    [...sides[0], ...sides[1]].forEach(([x, y], k) => (k === 0 ? path.moveTo(x, y) : path.lineTo(x, y)));
    path.closePath();
    addDisc(path, middle[0].x, middle[0].y, half(0));
    addDisc(path, middle.at(-1).x, middle.at(-1).y, half(middle.length - 1));
    return path;
}

function drawChain(scene, chain) {
    scene.pen.fillStyle = scene.colors.body;
    scene.pen.fill(chainPath(scene, chain));
}

/** Returns the smooth closed curve through the points of a skin. */
function skinPath(scene, skin) {
    const path = new Path2D();
    const count = skin.outline.length;
    if (count < 3)
        return path;
    const places = skin.outline.map((point) => at(scene, point));
    const place = (k) => places[(k + count) % count];
    path.moveTo(places[0].x, places[0].y);
    for (let k = 0; k < count; ++k) {
        const [a, b, c, d] = [place(k - 1), place(k), place(k + 1), place(k + 2)];
        path.bezierCurveTo(b.x + (c.x - a.x) / 6, b.y + (c.y - a.y) / 6, c.x - (d.x - b.x) / 6, c.y - (d.y - b.y) / 6,
                           c.x, c.y);
    }
    return path;
}

function drawSkin(scene, skin) {
    const count = skin.outline.length;
    if (count < 3)
        return;
    scene.pen.fillStyle = scene.colors.body;
    scene.pen.fill(skinPath(scene, skin));
    if (skin.front < 0)
        return;
    const middle = { x: 0, y: 0 };
    for (const point of skin.outline) {
        const one = at(scene, point);
        middle.x += one.x / count;
        middle.y += one.y / count;
    }
    const front = at(scene, skin.front);
    const ahead = { x: front.x - middle.x, y: front.y - middle.y };
    const way = Math.hypot(ahead.x, ahead.y);
    if (way <= 0)
        return;
    let across = { x: -ahead.y / way, y: ahead.x / way };
    if (across.x < 0)
        across = { x: -across.x, y: -across.y };
    drawEyes(scene, { x: middle.x + 0.45 * ahead.x, y: middle.y + 0.45 * ahead.y }, 0.5 * way, across, 0,
             velocityOf(scene, skin.front));
}

/** The velocity of a point, px/frame: from its places where the page has no velocities. */
function velocityOf(scene, point) {
    const { part, i, every } = scene;
    if (part.vx.length > 0)
        return { x: part.vx[point][i], y: part.vy[point][i] };
    if (i === 0)
        return { x: 0, y: 0 };
    return { x: (part.x[point][i] - part.x[point][i - 1]) / every,
             y: (part.y[point][i] - part.y[point][i - 1]) / every };
}

/** Draws two eyes that look where the body goes. */
function drawEyes(scene, centre, radius, across, up, velocity) {
    if (radius < smallestFace || !scene.hasEyes)
        return;
    const { colors } = scene;
    const z = radius / 15;
    const speed = Math.hypot(velocity.x, velocity.y);
    const share = speed > 0 ? Math.min(1, speed / 6) / speed : 0;
    const gaze = { x: velocity.x * share, y: velocity.y * share };
    for (const side of [-5.2, 5.2]) {
        const x = centre.x + z * (side * across.x + 2 * gaze.x);
        const y = centre.y - radius * up + z * (side * across.y + 2 * gaze.y);
        putDot(scene, colors.bodyInk, x, y, 3.6 * z);
        putDot(scene, colors.body, x + 1.5 * z * gaze.x, y + 1.5 * z * gaze.y, 1.9 * z);
        if (z >= 1.5)
            putDot(scene, colors.bodyInk, x + 1.5 * z * gaze.x - 0.6 * z, y + 1.5 * z * gaze.y - 0.7 * z, 0.55 * z);
    }
}

function drawBodies(scene) {
    const { pen, colors, camera } = scene;
    scene.part.view.bodies.forEach((body, point) => {
        if (body.shape === "none")
            return;
        const place = at(scene, point);
        const radius = camera.radius(body.radius);
        if (!isSeen(scene, place, radius))
            return;
        if (body.shape === "joint" && !body.fixed) {
            const rim = Math.min(3, Math.max(1, 0.45 * radius));
            pen.fillStyle = colors.stick;
            disc(pen, place.x, place.y, radius);
            pen.fillStyle = colors.scene;
            disc(pen, place.x, place.y, radius - rim);
            return;
        }
        drawDisc(scene, place.x, place.y, radius);
        if (body.fixed) {
            const arm = Math.max(2, 0.45 * radius);
            useStroke(pen, colors.scene, Math.min(3, Math.max(1.2, 0.3 * radius)));
            for (const turn of [1, -1])
                line(pen, { x: place.x - arm, y: place.y - turn * arm }, { x: place.x + arm, y: place.y + turn * arm });
        } else if (body.shape === "body") {
            drawEyes(scene, place, radius, { x: 1, y: 0 }, 2.5 / 15, velocityOf(scene, point));
        }
    });
}
