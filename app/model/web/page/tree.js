// Draws a tree: its branches taper, and its tips blossom.

/** What stays the same in all frames: how thin each branch ends, and which ones are tips. */
function planTree(tree) {
    const narrow = tree.width.map(() => 0);
    const isTip = tree.width.map(() => true);
    tree.parent.forEach((parent, branch) => {
        if (parent < 0)
            return;
        isTip[parent] = false;
        narrow[parent] = Math.min(tree.width[parent], Math.max(narrow[parent], tree.width[branch]));
    });
    tree.width.forEach((width, branch) => {
        if (isTip[branch])
            narrow[branch] = 0.55 * width;
    });
    const tips = isTip.filter(Boolean).length;
    return { narrow, isTip, blossomEvery: 1 + Math.floor(tips / 1500) };
}

/** A number from 0 to 1 that is always the same for a branch. */
function chance(branch, what) {
    const value = Math.sin(branch * 12.9898 + what * 78.233 + 11) * 43758.5453;
    return value - Math.floor(value);
}

/** Where a branch is, in px of the picture, and its direction; null if it is not seen. */
function limbOf(scene, branch) {
    const { part, i, camera } = scene;
    const from = at(scene, branch);
    const length = part.view.tree.length[branch] * camera.zoom;
    if (!isSeen(scene, from, length + 4))
        return null;
    const angle = part.angle[branch][i] * Math.PI / 180;
    const along = { x: Math.cos(angle), y: Math.sin(angle) };
    return { from, to: { x: from.x + length * along.x, y: from.y + length * along.y }, angle, along };
}

function drawTree(scene) {
    const { part, pen, camera, colors } = scene;
    const tree = part.view.tree;
    if (!tree)
        return;
    part.plan ??= planTree(tree);
    const isOpen = part.view.dusk;
    const twigs = new Map(); // by width: one path each
    const tips = [];
    pen.fillStyle = isOpen ? colors.bark : colors.body;
    tree.width.forEach((wide, branch) => {
        const limb = limbOf(scene, branch);
        if (!limb)
            return;
        const { from, to, angle } = limb;
        const start = wide * camera.zoom;
        const end = part.plan.narrow[branch] * camera.zoom;
        if (part.plan.isTip[branch] && start <= 5)
            tips.push({ branch, to });
        if (start < 2) {
            const width = Math.max(0.3, Math.round(4 * (start + end) / 2) / 4);
            if (!twigs.has(width))
                twigs.set(width, new Path2D());
            twigs.get(width).moveTo(from.x, from.y);
            twigs.get(width).lineTo(to.x, to.y);
            return;
        }
        const turn = angle + Math.PI / 2;
        pen.beginPath();
        pen.arc(from.x, from.y, start / 2, turn, turn + Math.PI);
        pen.arc(to.x, to.y, end / 2, turn + Math.PI, turn + 2 * Math.PI);
        pen.closePath();
        pen.fill();
    });
    for (const [width, path] of twigs) {
        useStroke(pen, isOpen ? colors.twigs : colors.body, width);
        pen.lineCap = "butt";
        pen.stroke(path);
    }
    drawBlossoms(scene, tips);
}

function drawBlossoms(scene, tips) {
    const { part, camera, colors, pen } = scene;
    const size = Math.min(camera.zoom, Math.sqrt(camera.zoom));
    const paths = [new Path2D(), new Path2D(), new Path2D()];
    for (const { branch, to } of tips) {
        if (chance(branch, 2) * part.plan.blossomEvery >= 1)
            continue;
        const radius = (1.5 + 1.1 * chance(branch, 0)) * size;
        const path = paths[Math.floor(3 * chance(branch, 1))];
        path.moveTo(to.x + radius, to.y);
        path.arc(to.x, to.y, radius, 0, 2 * Math.PI);
    }
    paths.forEach((path, k) => {
        pen.fillStyle = [colors.blossom0, colors.blossom1, colors.blossom2][k];
        pen.fill(path);
    });
}
