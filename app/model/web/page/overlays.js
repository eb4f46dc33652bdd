// Draws the lines and labels that explain a step, and the trails of the bodies.

const trailFrames = 20;
const mostTrailed = 600; // bodies
const unitArrow = 38; // px of the screen: the arrow of the legend
const longestArrow = 100; // px of the screen
const longestVelocity = 140;

/** Reads the overlays of a part of the run. */
function readDrawings(run, part) {
    part.drawings.forEach((drawings, k) => {
        const next = part.drawings[k + 1];
        const count = (next ? next.first : part.count) - drawings.first;
        drawings.numbers = drawings.numbers.map((at) => run.column(at, count));
    });
}

/** Returns the overlays of a frame. */
function overlaysAt(part, i) {
    const drawings = part.drawings.findLast((one) => one.first <= i);
    if (!drawings)
        return [];
    return drawings.shapes.map((shape, k) => {
        const [label, ax, ay, bx, by, size] = drawings.numbers.slice(6 * k, 6 * k + 6)
            .map((numbers) => numbers[i - drawings.first]);
        return { shape, label: drawings.labels[label], ax, ay, bx, by, size };
    });
}

/** Returns the longest arrow of an acceleration in each frame of the page, px/frame². */
function longestPulls(run) {
    const longest = new Float64Array(run.count);
    for (const part of run.figures.flatMap((figure) => figure.parts)) {
        for (const drawings of part.drawings) {
            drawings.shapes.forEach((shape, k) => {
                if (shape !== "arrow")
                    return;
                const [x, y] = [drawings.numbers[6 * k + 3], drawings.numbers[6 * k + 4]];
                const first = part.first + drawings.first;
                x.forEach((one, i) => { longest[first + i] = Math.max(longest[first + i], Math.hypot(one, y[i])); });
            });
        }
    }
    return longest;
}

/** Returns the largest speed of a body in each frame of the page, px/frame. */
function largestSpeeds(run) {
    const largest = new Float64Array(run.count);
    for (const { first, view, vx, vy } of run.figures[0].parts) {
        vx.forEach((x, point) => {
            if (view.bodies[point].shape === "none")
                return;
            x.forEach((one, i) => { largest[first + i] = Math.max(largest[first + i], Math.hypot(one, vy[point][i])); });
        });
    }
    return largest;
}

/**
 * Returns what an arrow of 38 px stands for in each frame: 1, 2 or 5 times a power of ten. The longest arrow has at most
 * `room` px. The scale stays while that is so, as in the window.
 */
function unitsOf(longest, room) {
    let unit = 0;
    return longest.map((length) => {
        const least = length * unitArrow / room;
        if (least > 0 && (least > unit || least < 0.15 * unit)) {
            const power = 10 ** Math.floor(Math.log10(least));
            unit = Math.max(0.01, [1, 2, 5, 10].map((step) => step * power).find((one) => one >= least) ?? least);
        }
        return unit;
    });
}

/** Draws the velocities, from the edges of the bodies. */
function drawVelocities(scene) {
    const { part, i, pen, colors, velocityUnit } = scene;
    if (part.vx.length === 0 || velocityUnit === 0)
        return;
    useStroke(pen, colors.ink2, 2);
    part.view.bodies.forEach((body, point) => {
        const x = part.vx[point][i] * unitArrow / velocityUnit;
        const y = part.vy[point][i] * unitArrow / velocityUnit;
        const length = Math.hypot(x, y);
        const place = at(scene, point);
        const radius = discRadius(scene, point);
        if (radius === 0 || !(length >= 3) || !isSeen(scene, place, length + radius))
            return;
        const u = { x: x / length, y: y / length };
        const from = { x: place.x + (radius + 3) * u.x, y: place.y + (radius + 3) * u.y };
        const tip = { x: from.x + x, y: from.y + y };
        const head = Math.min(10.2, length);
        const half = head * 0.51;
        line(pen, from, tip);
        pen.beginPath();
        pen.moveTo(tip.x - head * u.x - half * u.y, tip.y - head * u.y + half * u.x);
        pen.lineTo(tip.x, tip.y);
        pen.lineTo(tip.x - head * u.x + half * u.y, tip.y - head * u.y - half * u.x);
        pen.stroke();
    });
}

function drawArrow(scene, from, to) {
    const { pen, colors } = scene;
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    if (length < 1)
        return;
    const u = { x: (to.x - from.x) / length, y: (to.y - from.y) / length };
    const head = Math.min(10, length);
    const neck = { x: to.x - head * u.x, y: to.y - head * u.y };
    const tip = [[to.x, to.y], [neck.x - 0.45 * head * u.y, neck.y + 0.45 * head * u.x],
                 [neck.x + 0.45 * head * u.y, neck.y - 0.45 * head * u.x]];
    useStroke(pen, colors.scene, 5);
    line(pen, from, neck);
    useStroke(pen, colors.ink2, 2.2);
    line(pen, from, neck);
    pen.fillStyle = colors.ink2;
    fillPolygon(pen, tip);
}

/** Writes a text that stays readable over lines. */
function drawWords(scene, text, x, y, color, font = scene.font) {
    const pen = scene.pen;
    pen.font = font;
    pen.textAlign = "left";
    pen.textBaseline = "alphabetic";
    useStroke(pen, scene.colors.scene, 4);
    pen.strokeText(text, x, y);
    pen.fillStyle = color;
    pen.fillText(text, x, y);
}

function drawAngle(scene, overlay, place, radius) {
    const { pen, colors } = scene;
    useStroke(pen, colors.ink3, 1);
    line(pen, place, { x: place.x + radius + 14, y: place.y });
    useStroke(pen, colors.ink2, 1.5);
    pen.beginPath();
    pen.arc(place.x, place.y, radius, 0, overlay.size, overlay.size < 0);
    pen.stroke();
}

function drawWind(scene, place) {
    const { pen, colors, frame, isStill } = scene;
    for (let streak = 0; streak < 34; ++streak) {
        const turn = (streak + 0.8 * chance(streak, 0)) * 2 * Math.PI / 34;
        const u = { x: Math.cos(turn), y: Math.sin(turn) };
        const way = ((isStill ? 0 : frame) / 40 + chance(streak, 1)) % 1;
        const from = 40 + 130 * way;
        const length = 50 + 90 * chance(streak, 2);
        const bend = 26 * (chance(streak, 3) - 0.5);
        const on = (distance, side) => [place.x + distance * u.x - side * u.y, place.y + distance * u.y + side * u.x];
        useStroke(pen, faded(colors.wind, 0.8 * Math.sin(Math.PI * way)), 1.5 + 0.9 * chance(streak, 4), [2, 4]);
        pen.beginPath();
        pen.moveTo(...on(from, 0));
        pen.quadraticCurveTo(...on(from + length / 2, bend), ...on(from + length, 0.2 * bend));
        pen.stroke();
    }
    useStroke(pen, faded(colors.wind, 0.75), 1.6);
    pen.beginPath();
    pen.arc(place.x, place.y, 26, 0, 2 * Math.PI);
    pen.stroke();
    pen.fillStyle = faded(colors.wind, 0.28);
    disc(pen, place.x, place.y, 15);
}

/** The radius of the body at a place, px of the screen; 0 if there is none. */
function bodyAt(scene, x, y) {
    const { part, i } = scene;
    const near = (point) => Math.abs(part.x[point][i] - x) < 0.01 && Math.abs(part.y[point][i] - y) < 0.01;
    const point = part.view.bodies.findIndex((body, k) => body.shape !== "none" && near(k));
    return point < 0 ? 0 : discRadius(scene, point);
}

/** Draws an overlay, and writes its label near it. */
function drawOverlay(scene, overlay) {
    const { pen, colors, camera } = scene;
    const place = camera.at(overlay.ax + scene.shiftX, overlay.ay + scene.shiftY);
    let anchor = place;
    switch (overlay.shape) {
    case "cross":
        useStroke(pen, colors.ink2, 1.5);
        line(pen, { x: place.x - 7, y: place.y }, { x: place.x + 7, y: place.y });
        line(pen, { x: place.x, y: place.y - 7 }, { x: place.x, y: place.y + 7 });
        break;
    case "ring": {
        const radius = Math.min(4000, overlay.size * camera.zoom);
        useStroke(pen, colors.ink3, 1.2, [2, 4]);
        pen.beginPath();
        pen.arc(place.x, place.y, radius, 0, 2 * Math.PI);
        pen.stroke();
        anchor = { x: place.x + radius * Math.SQRT1_2, y: place.y - radius * Math.SQRT1_2 };
        break;
    }
    case "arrow": {
        const scale = unitArrow / scene.pullUnit;
        const length = Math.hypot(overlay.bx, overlay.by) * scale;
        if (!(length >= 3 && length < mostSize))
            return;
        const away = (bodyAt(scene, overlay.ax, overlay.ay) + 8) / length;
        const end = (share) => ({ x: place.x + share * scale * overlay.bx, y: place.y + share * scale * overlay.by });
        anchor = end(away + 1);
        drawArrow(scene, end(away), anchor);
        break;
    }
    case "line": {
        const end = camera.at(overlay.bx + scene.shiftX, overlay.by + scene.shiftY);
        useStroke(pen, colors.ink2, 1.2, [5, 4]);
        line(pen, place, end);
        anchor = { x: (place.x + end.x) / 2, y: (place.y + end.y) / 2 };
        break;
    }
    case "angle": {
        const radius = Math.max(22, bodyAt(scene, overlay.ax, overlay.ay) + 12);
        drawAngle(scene, overlay, place, radius);
        anchor = { x: place.x + (radius + 6) * Math.cos(overlay.size / 2),
                   y: place.y + (radius + 6) * Math.sin(overlay.size / 2) };
        break;
    }
    case "wind":
        drawWind(scene, place);
        break;
    }
    pen.setLineDash([]);
    if (overlay.label)
        drawLabel(scene, overlay.label, anchor);
}

const widths = new Map(); // of labels, px

function widthOf(scene, text) {
    let width = widths.get(text);
    if (width === undefined) {
        if (widths.size > 2000)
            widths.clear();
        scene.pen.font = scene.font;
        width = scene.pen.measureText(text).width;
        widths.set(text, width);
    }
    return width;
}

/** Returns whether a line crosses a box (Liang and Barsky). */
function crosses([from, to], box) {
    let first = 0;
    let last = 1;
    const cut = (start, way, low, high) => {
        if (way === 0)
            return start >= low && start <= high;
        const [near, far] = [(low - start) / way, (high - start) / way].sort((a, b) => a - b);
        first = Math.max(first, near);
        last = Math.min(last, far);
        return first <= last;
    };
    return cut(from.x, to.x - from.x, box.left, box.right) && cut(from.y, to.y - from.y, box.top, box.bottom);
}

/** Writes a label beside its place, where neither an earlier one nor a body is, and no line if there is such a spot. */
function drawLabel(scene, text, place) {
    const width = widthOf(scene, text);
    const spots = [[10, -8], [10, 18], [-10 - width, -8], [-10 - width, 18], [-width / 2, -16], [-width / 2, 28],
                   [20, -26], [20, 36], [-20 - width, -26], [-20 - width, 36]];
    const boxes = spots.map(([x, y]) => new Box(place.x + x - 2, place.y + y - 13, place.x + x + width + 2,
                                                place.y + y + 3));
    const inside = new Box(0, 0, scene.camera.width, scene.camera.height);
    const free = boxes.filter((box) => box.cut(inside).width === box.width &&
                                       !scene.labels.some((one) => !one.cut(box).isEmpty));
    const box = free.find((one) => !scene.lines.some((stroke) => crosses(stroke, one))) ?? free[0] ?? boxes[0];
    scene.labels.push(box);
    drawWords(scene, text, box.left + 2, box.bottom - 3, scene.colors.ink2);
}

/** Returns the lines that labels avoid: those that explain the step, and the links of a few bodies. */
function linesToAvoid(scene, overlays) {
    const { view } = scene.part;
    if (view.bodies.length > fewBodies)
        return [];
    const lines = overlays.filter((one) => one.shape === "line").map((one) =>
        [scene.camera.at(one.ax + scene.shiftX, one.ay + scene.shiftY), scene.camera.at(one.bx + scene.shiftX, one.by + scene.shiftY)]);
    view.springs.forEach((spring) => lines.push([at(scene, spring.a), endOf(scene, spring)]));
    view.legs.filter((leg) => !leg.curve).forEach((leg) => lines.push([at(scene, leg.from), at(scene, leg.to)]));
    view.sticks.forEach((stick) => lines.push([at(scene, stick.a), at(scene, stick.b)]));
    return lines;
}

/** Returns the boxes of the bodies, which labels avoid. */
function boxesOfBodies(scene) {
    const { bodies } = scene.part.view;
    if (bodies.length > fewBodies)
        return [];
    return bodies.map((body, point) => ({ place: at(scene, point), radius: discRadius(scene, point) }))
        .filter(({ radius }) => radius > 0)
        .map(({ place, radius }) => Box.around(place.x, place.y, radius));
}

/** Draws the hand that moved something in this run. Its fingertip is at `place`. */
function drawHand(pen, colors, place) {
    const hand = new Path2D();
    hand.roundRect(place.x - 2.2, place.y, 4.4, 15, 2.2);
    for (let finger = 0; finger < 3; ++finger)
        hand.roundRect(place.x + 1.6 + 4 * finger, place.y + 7 + finger, 4.6, 8, 2.3);
    hand.roundRect(place.x - 2.2, place.y + 10.5, 16.4, 12.5, 5);
    hand.roundRect(place.x - 7.5, place.y + 11, 9, 4.6, 2.3);
    useStroke(pen, colors.scene, 6);
    pen.stroke(hand);
    useStroke(pen, colors.ink, 3);
    pen.stroke(hand);
    pen.fillStyle = colors.scene;
    pen.fill(hand);
}

/** Draws where the bodies have been in the last frames. Those that hardly move have no trail. */
function drawTrails(scene) {
    const { part, i, pen, camera, every } = scene;
    const bodies = part.view.bodies;
    const points = [...bodies.keys()];
    let trailed = points.filter((point) => bodies[point].shape === "body");
    if (trailed.length === 0)
        trailed = points.filter((point) => bodies[point].shape !== "none");
    if (bodies.length > mostTrailed || part.view.tree)
        return;
    const marks = Math.floor(trailFrames / every);
    const piece = trailed.length > fewBodies ? Math.max(1, Math.floor(marks / 5)) : 1; // frames
    const place = (point, k) => camera.at(part.x[point][k] + scene.shiftX, part.y[point][k] + scene.shiftY);
    for (let back = marks; back > 0; back -= piece) {
        if (i - back + piece < 1)
            continue;
        useStroke(pen, faded(scene.colors.body, 0.05 + 0.3 * (1 - (back - piece) / marks)), 2);
        pen.lineCap = "butt"; // round ones would be darker where they overlap
        for (const point of trailed) {
            const from = place(point, Math.max(0, i - back));
            const to = place(point, i - back + piece);
            if (Math.abs(to.x - from.x) + Math.abs(to.y - from.y) > 0.2)
                line(pen, from, to);
        }
    }
}
