// Draws what does not move: the grid, walls, floors, ramps, the ground and the sky.

const hatchStep = 12; // px of the screen

/** Draws dots every 25 px and crosses every 100 px, or farther apart where these would be too dense. */
function drawGrid(scene) {
    const { pen, camera, colors } = scene;
    let step = 25 * camera.zoom;
    while (step < 18)
        step *= 2;
    const origin = camera.at(0, 0);
    const firstRow = Math.floor(-origin.y / step);
    const firstColumn = Math.floor(-origin.x / step);
    pen.fillStyle = colors.dots;
    useStroke(pen, colors.dots, 1.3);
    pen.lineCap = "butt";
    pen.beginPath();
    for (let row = firstRow; origin.y + row * step < camera.height + step; ++row) {
        for (let column = firstColumn; origin.x + column * step < camera.width + step; ++column) {
            const x = origin.x + column * step;
            const y = origin.y + row * step;
            if (row % 4 !== 0 || column % 4 !== 0) {
                pen.fillRect(x - 1.15, y - 1.15, 2.3, 2.3);
                continue;
            }
            pen.moveTo(x - 4, y);
            pen.lineTo(x + 4, y);
            pen.moveTo(x, y - 4);
            pen.lineTo(x, y + 4);
        }
    }
    pen.stroke();
}

/** Fills the solid side of an edge, a little darker near the edge. `inwards`: into the solid. */
function drawSolid(scene, left, top, right, bottom, edge, inwards) {
    const { pen, colors, isDark } = scene;
    if (right <= left || bottom <= top)
        return;
    const shade = pen.createLinearGradient(edge.x, edge.y, edge.x + 26 * inwards.x, edge.y + 26 * inwards.y);
    shade.addColorStop(0, mixed(colors.win, isDark ? "#ffffff" : "#000000", 0.1));
    shade.addColorStop(1, colors.win);
    pen.fillStyle = shade;
    pen.fillRect(left, top, right - left, bottom - top);
}

function firstHatch(from, anchor) {
    return from - ((from - anchor) % hatchStep) - 2 * hatchStep;
}

function useHatch(scene) {
    useStroke(scene.pen, scene.colors.line2, 1.3);
    scene.pen.lineCap = "butt";
    scene.pen.beginPath();
}

function hatchFloor(scene, left, right, anchor, y) {
    for (let x = firstHatch(left, anchor); x < right; x += hatchStep) {
        scene.pen.moveTo(x, y + 10);
        scene.pen.lineTo(x + 8, y + 1);
    }
}

function hatchWall(scene, top, bottom, anchor, x, solid) {
    for (let y = firstHatch(top, anchor); y < bottom - 8; y += hatchStep) {
        scene.pen.moveTo(x + solid * 10, y - solid * 4);
        scene.pen.lineTo(x + solid, y + solid * 4);
    }
}

function useEdge(scene) {
    useStroke(scene.pen, scene.colors.contact, 2);
    scene.pen.lineCap = "butt";
    scene.pen.lineJoin = "miter";
}

function drawRoom(scene) {
    const room = scene.part.view.room;
    if (!room)
        return;
    const { pen, camera } = scene;
    const { width, height } = camera;
    const far = 1e5; // a wall that is infinitely far away
    const x = (value, otherwise) => value === null ? otherwise
                                                   : Math.round(camera.at(value + scene.shiftX, 0).x);
    const left = x(room.left, -far);
    const right = x(room.right, far);
    const floor = Math.round(camera.at(0, room.floor + scene.shiftY).y);
    drawSolid(scene, 0, floor, width, height, { x: left, y: floor }, { x: 0, y: 1 });
    drawSolid(scene, 0, 0, left, Math.min(floor, height), { x: left, y: floor }, { x: -1, y: 0 });
    drawSolid(scene, right, 0, width, Math.min(floor, height), { x: right, y: floor }, { x: 1, y: 0 });
    useHatch(scene);
    if (floor < height + 10)
        hatchFloor(scene, Math.max(left, 0), Math.min(right, width), left, floor);
    const bottom = Math.min(floor, height + 10);
    if (left > -10)
        hatchWall(scene, 0, bottom, floor, left, -1);
    if (right < width + 10)
        hatchWall(scene, 0, bottom, floor, right, 1);
    pen.stroke();
    useEdge(scene);
    pen.beginPath();
    pen.moveTo(left, -4);
    pen.lineTo(left, floor);
    pen.lineTo(right, floor);
    pen.lineTo(right, -4);
    pen.stroke();
}

function drawRamps(scene) {
    const { pen, camera, colors } = scene;
    for (const ramp of scene.part.view.ramps) {
        const [nx, ny] = ramp.normal;
        const way = { x: -ny, y: nx };
        const place = camera.at(...ramp.through);
        const middle = { x: camera.width / 2 - place.x, y: camera.height / 2 - place.y };
        const reach = camera.width + camera.height;
        if (Math.abs(middle.x * nx + middle.y * ny) > reach)
            continue;
        const along = middle.x * way.x + middle.y * way.y;
        const first = firstHatch(along - reach, 0);
        const last = along + reach;
        const on = (distance, inwards) => [place.x + distance * way.x - inwards * nx,
                                           place.y + distance * way.y - inwards * ny];
        pen.fillStyle = colors.win;
        fillPolygon(pen, [on(first, 0), on(last, 0), on(last, 2 * reach), on(first, 2 * reach)]);
        useHatch(scene);
        for (let distance = first; distance < last; distance += hatchStep) {
            pen.moveTo(...on(distance, 10));
            pen.lineTo(...on(distance + 8, 1));
        }
        pen.stroke();
        useEdge(scene);
        pen.beginPath();
        pen.moveTo(...on(first, 0));
        pen.lineTo(...on(last, 0));
        pen.stroke();
    }
}

/** Writes distances from the left of the stage below the ground. */
function drawDistances(scene, y) {
    const { pen, camera, colors } = scene;
    const home = scene.part.view.stage[0];
    let step = 100;
    for (const factor of [2, 2.5, 2, 2, 2.5, 2]) {
        if (step * camera.zoom >= 70)
            break;
        step *= factor;
    }
    const left = camera.back(0, 0).x - home;
    const right = camera.back(camera.width, 0).x - home;
    useStroke(pen, colors.contact, 1.5);
    pen.lineCap = "butt";
    pen.fillStyle = colors.ink3;
    pen.font = scene.font;
    pen.textAlign = "center";
    pen.textBaseline = "top";
    pen.beginPath();
    for (let distance = Math.floor(left / step) * step; distance <= right + step; distance += step) {
        const x = Math.round(camera.at(home + distance, 0).x);
        pen.moveTo(x, y);
        pen.lineTo(x, y + 14);
        if (y + 32 <= camera.height)
            pen.fillText(`${distance < 0 ? "−" : ""}${Math.abs(distance)}\u202fpx`, x, y + 16);
    }
    pen.stroke();
}

function drawGround(scene) {
    const { ground, dusk, stage } = scene.part.view;
    if (ground === undefined || dusk)
        return;
    const { pen, camera } = scene;
    const home = camera.at(stage[0], ground);
    const y = Math.round(home.y);
    if (y > camera.height + 2)
        return;
    drawSolid(scene, 0, Math.max(0, y), camera.width, camera.height, { x: 0, y }, { x: 0, y: 1 });
    useHatch(scene);
    hatchFloor(scene, 0, camera.width, home.x, y);
    pen.stroke();
    drawDistances(scene, y);
    useEdge(scene);
    line(pen, { x: 0, y }, { x: camera.width, y });
}

/** The height at which the ground below an open sky begins. */
function horizonOf(scene) {
    const { tree, ground, stage } = scene.part.view;
    return tree && scene.part.y.length > 0 ? scene.part.y[0][scene.i] : ground ?? stage[1] + stage[3];
}

function drawSky(scene) {
    const { pen, camera, colors } = scene;
    const low = Math.min(3 * camera.height, Math.max(1, camera.at(0, horizonOf(scene)).y));
    const sky = pen.createLinearGradient(0, 0, 0, low);
    [colors.sky0, colors.sky1, colors.sky2, colors.sky3, colors.sky4].forEach((color, k) => {
        sky.addColorStop(k / 4, color);
    });
    pen.fillStyle = sky;
    pen.fillRect(0, 0, camera.width, camera.height);
}

/** The height of the meadow's edge above the horizon, px. */
function swell(x) {
    return 4 * Math.sin(x / 173 + 0.6) + 2 * Math.sin(x / 61);
}

function drawMeadow(scene) {
    const { tree, dusk, stage } = scene.part.view;
    if (!dusk)
        return;
    const { pen, camera, colors } = scene;
    const horizon = horizonOf(scene);
    const foot = swell(tree ? scene.part.x[0][scene.i] : stage[0] + stage[2] / 2);
    const edge = [[0, camera.height + 1]];
    for (let x = 0; x <= camera.width + 8; x += 8) {
        const place = camera.back(x, 0).x;
        edge.push([x, camera.at(place, horizon - swell(place) + foot).y - 2]);
    }
    edge.push([camera.width + 8, camera.height + 1]);
    pen.fillStyle = colors.meadow;
    fillPolygon(pen, edge);
}
