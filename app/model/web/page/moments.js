// Draws the run at earlier moments and the ghost, as outlines.

const onionStep = 4; // pictures from one onion skin to the next
const onionSkins = 6;

/** Adds a circle to a path. */
function addDisc(path, x, y, radius) {
    path.moveTo(x + radius, y);
    path.arc(x, y, radius, 0, 2 * Math.PI);
}

/** Returns a limb with round ends. */
function limbPath(from, to, width) {
    const turn = Math.atan2(to.y - from.y, to.x - from.x) + Math.PI / 2;
    const path = new Path2D();
    path.arc(from.x, from.y, width / 2, turn, turn + Math.PI);
    path.arc(to.x, to.y, width / 2, turn + Math.PI, turn + 2 * Math.PI);
    path.closePath();
    return path;
}

/** Draws the sides of thick branches, and thin ones as lines. */
function strokeBranches(scene) {
    const { part, camera, pen } = scene;
    part.plan ??= planTree(part.view.tree);
    part.view.tree.width.forEach((width, branch) => {
        const limb = limbOf(scene, branch);
        if (!limb)
            return;
        const { from, to, along } = limb;
        const half = width * camera.zoom / 2;
        for (const side of half < 2.5 ? [0] : [-half, half]) {
            const far = side * part.plan.narrow[branch] / width;
            line(pen, { x: from.x - side * along.y, y: from.y + side * along.x },
                 { x: to.x - far * along.y, y: to.y + far * along.x });
        }
    });
}

/** Draws what connects the bodies of a moment. Short paths one by one: a browser takes long for one path of all. */
function strokeLinks(scene) {
    const { pen, camera } = scene;
    const { view } = scene.part;
    for (const leg of view.legs) {
        const foot = at(scene, leg.to);
        const body = at(scene, leg.from);
        pen.beginPath();
        pen.moveTo(foot.x, foot.y);
        if (leg.curve)
            pen.quadraticCurveTo(foot.x, foot.y - leg.curve * camera.zoom, body.x, body.y);
        else
            pen.lineTo(body.x, body.y);
        pen.stroke();
    }
    view.sticks.forEach((stick) => line(pen, at(scene, stick.a), at(scene, stick.b)));
    view.springs.forEach((spring) => line(pen, at(scene, spring.a), endOf(scene, spring)));
}

/**
 * Draws the outlines of a moment. `style` has the `name` of the kind of outline, its `color` and `width`, the `dash` and the
 * `fill` of closed shapes.
 */
function drawOutlines(scene, style) {
    const { pen, camera } = scene;
    const { view } = scene.part;
    useStroke(pen, style.color, style.width, style.dash);
    pen.fillStyle = style.fill;
    if (view.tree)
        strokeBranches(scene);
    strokeLinks(scene);
    const shapes = [
        ...view.limbs.map((limb) => limbPath(at(scene, limb.a), at(scene, limb.b), limb.width * camera.zoom)),
        ...view.chains.map((chain) => chainPath(scene, chain)),
        ...view.skins.map((skin) => skinPath(scene, skin)),
    ];
    for (const shape of shapes) {
        pen.fill(shape);
        pen.stroke(shape);
    }
    pen.setLineDash([]);
    view.bodies.forEach((body, point) => {
        const place = at(scene, point);
        const radius = camera.radius(body.radius);
        if (body.shape !== "none" && isSeen(scene, place, radius))
            putOutline(scene, style, place, radius);
    });
}

function putOutline(scene, style, place, radius) {
    const paint = (pen) => {
        useStroke(pen, style.color, style.width, style.dash);
        pen.fillStyle = style.fill;
        pen.beginPath();
        pen.arc(0, 0, radius, 0, 2 * Math.PI);
        pen.fill();
        pen.stroke();
    };
    if (radius < 200) {
        put(scene, stamp(scene, `${style.name} ${radius}`, radius + 2, paint), place.x, place.y);
        return;
    }
    scene.pen.save(); // too large to keep
    scene.pen.translate(place.x, place.y);
    paint(scene.pen);
    scene.pen.restore();
}

/**
 * Draws earlier moments; the earlier, the fainter. In a crowd each takes some milliseconds. So it is kept as a picture while
 * the view stays.
 */
function drawOnion(scene, figure, painter) {
    const { pen, camera } = scene;
    const step = onionStep * scene.every;
    const body = scene.colors.body;
    const kept = scene.part.view.bodies.length > fewBodies ? painter.kept?.skins : null;
    // At multiples of the step, so that an onion skin keeps its place while it fades.
    const latest = Math.floor((scene.frame - 1) / step) * step;
    for (let k = onionSkins - 1; k >= 0; --k) {
        const frame = latest - k * step;
        const index = scene.index - (scene.frame - frame) / scene.every;
        if (frame < 0 || index < 0)
            continue;
        const past = partAt(figure, index);
        const alpha = 0.55 * (1 - k / onionSkins);
        if (past.part.names.length !== scene.part.names.length)
            continue;
        const draw = (onto, name, strength) =>
            drawOutlines({ ...scene, ...past, pen: onto }, { name, color: faded(body, strength), width: 1.2, dash: [],
                                                             fill: faded(body, 0.22 * strength) });
        if (!kept) {
            draw(pen, `skin${k}`, alpha);
            continue;
        }
        const place = frame / step % onionSkins;
        if (kept[place]?.frame !== frame)
            kept[place] = { frame, picture: painter.paint(kept[place]?.picture, (onto) => draw(onto, "skin", 1)) };
        pen.globalAlpha = alpha;
        pen.drawImage(kept[place].picture, 0, 0, camera.width, camera.height);
        pen.globalAlpha = 1;
    }
}

/** Returns the moment of the ghost that belongs to frame `index` of the page; null where it is the same as the run. */
function ghostAt(run, index) {
    const part = run.ghost?.parts.findLast((one) => one.first <= index);
    const i = part ? index - part.first : 0;
    if (!part || i >= part.count)
        return null;
    const own = partAt(run.figures[0], index);
    const isSame = part.names.length === own.part.names.length &&
        part.x.every((x, k) => Math.abs(x[i] - own.part.x[k][own.i]) < 2e-6 &&
                               Math.abs(part.y[k][i] - own.part.y[k][own.i]) < 2e-6);
    return isSame ? null : { part, i };
}

function drawGhost(scene, moment) {
    drawOutlines({ ...scene, ...moment }, { name: "ghost", color: faded(scene.colors.ghost, 0.9), width: 1.5, dash: [3, 4],
                                            fill: "transparent" });
}
