// Which part of the scene is shown, and where. As app/ui/scene/framing.cpp does it in the window.

const leastZoom = 0.01;
const mostZoom = 16;
const frameBorder = 24; // px of the screen around the bodies
const mostSize = 1e6; // px of the screen: no canvas draws farther away

class Box {
    constructor(left = Infinity, top = Infinity, right = -Infinity, bottom = -Infinity) {
        Object.assign(this, { left, top, right, bottom });
    }
    get width() { return this.right - this.left; }
    get height() { return this.bottom - this.top; }
    get isEmpty() { return !(this.right >= this.left && this.bottom >= this.top); }
    get middle() { return { x: (this.left + this.right) / 2, y: (this.top + this.bottom) / 2 }; }
    static around(x, y, half) { return new Box(x - half, y - half, x + half, y + half); }
    united(other) {
        return new Box(Math.min(this.left, other.left), Math.min(this.top, other.top),
                       Math.max(this.right, other.right), Math.max(this.bottom, other.bottom));
    }
    cut(other) {
        return new Box(Math.max(this.left, other.left), Math.max(this.top, other.top),
                       Math.min(this.right, other.right), Math.min(this.bottom, other.bottom));
    }
    moved(x, y) { return new Box(this.left + x, this.top + y, this.right + x, this.bottom + y); }
    grown(across, down) {
        return new Box(this.left - across, this.top - down, this.right + across, this.bottom + down);
    }
}

/** A zoom, and the place of the scene in the middle of the view. */
class Camera {
    constructor() {
        Object.assign(this, { zoom: 1, x: 0, y: 0, width: 1, height: 1 });
    }
    at(x, y) {
        const clamp = (value) => Math.min(mostSize, Math.max(-mostSize, value));
        return { x: clamp((x - this.x) * this.zoom + this.width / 2),
                 y: clamp((y - this.y) * this.zoom + this.height / 2) };
    }
    back(x, y) {
        return { x: (x - this.width / 2) / this.zoom + this.x, y: (y - this.height / 2) / this.zoom + this.y };
    }
    /** Small bodies stay visible. */
    radius(px) { return Math.max(2, px * this.zoom); }
    /** Moves the picture by px of the screen. */
    pan(x, y) {
        this.x -= x / this.zoom;
        this.y -= y / this.zoom;
    }
    /** Zooms, and keeps the place at (x, y) of the screen where it is. */
    zoomAt(factor, x, y) {
        const place = this.back(x, y);
        this.zoom = Math.min(mostZoom, Math.max(leastZoom, this.zoom * factor));
        const now = this.at(place.x, place.y);
        this.pan(x - now.x, y - now.y);
    }
}

function stageOf(view) {
    const [left, top, width, height] = view.stage;
    return new Box(left, top, left + width, top + height);
}

/** The height of the floor, ground or horizon; null if there is none near the stage. */
function baseOf(view) {
    const stage = stageOf(view);
    let base = view.room ? view.room.floor : view.ground ?? null;
    if (base === null && view.dusk)
        base = stage.bottom;
    return base !== null && base < stage.bottom + 2 * stage.height ? base : null;
}

function roomBox(view) {
    const stage = stageOf(view);
    const floor = baseOf(view) ?? stage.bottom;
    return new Box((view.room.left ?? stage.left) - 12, Math.min(stage.top, floor - 1),
                   (view.room.right ?? stage.right) + 12, floor);
}

/** The box of the bodies and branches at one moment. */
function bodiesBox(part, i, border) {
    let box = new Box();
    part.view.bodies.forEach((body, point) => {
        if (body.shape !== "none" || part.view.tree)
            box = box.united(Box.around(part.x[point][i], part.y[point][i], body.radius + border));
    });
    if (part.view.tree) {
        part.view.tree.length.forEach((length, branch) => {
            const angle = part.angle[branch][i] * Math.PI / 180;
            const x = part.x[branch][i] + length * Math.cos(angle);
            const y = part.y[branch][i] + length * Math.sin(angle);
            box = box.united(Box.around(x, y, border));
        });
    }
    return box;
}

/** The area of the bodies at the start, with room to move. */
function restBox(part, figures) {
    const view = part.view;
    const stage = stageOf(view);
    if (figures.length > 1)
        return figures.reduce((box, one) => box.united(stage.moved(one.shiftX, one.shiftY)), stage);
    if (view.room)
        return roomBox(view);
    if (view.tree)
        return stage.united(bodiesBox(part, 0, 0));
    if (view.dusk)
        return stage;
    let area = bodiesBox(part, 0, 12);
    area = area.united(Box.around(area.middle.x, area.middle.y, 75));
    area = area.united(Box.around(area.middle.x, area.middle.y, 110));
    if (view.ground !== undefined)
        area.bottom = view.ground;
    return area.width < stage.width && area.height < stage.height ? area : stage.united(area);
}

/** The x position that the view follows. */
function followedX(part, i) {
    return part.view.followed >= 0 ? part.x[part.view.followed][i] : 0;
}

/** The box of all moments of a figure, relative to what the view follows. */
function motionBox(figure) {
    let box = new Box();
    for (const part of figure.parts) {
        const every = Math.max(1, Math.ceil(part.count * part.view.bodies.length / 200000));
        for (let i = 0; i < part.count; i += every)
            box = box.united(bodiesBox(part, i, 0).moved(-followedX(part, i), 0));
    }
    return box;
}

/** Shows `area` in the view: a floor lies low, with room for what is written below it. */
function frameArea(camera, view, area, most) {
    const base = baseOf(view);
    const isEndless = !view.room && (view.ground !== undefined || view.dusk);
    const below = isEndless ? Math.max(68, 0.12 * camera.height) : 52;
    let zoom = Math.min((camera.width - 2 * frameBorder) / area.width,
                        (camera.height - 2 * frameBorder) / area.height);
    if (base !== null && base > area.top)
        zoom = Math.min(zoom, (camera.height - frameBorder - below) / (base - area.top));
    camera.zoom = Math.min(mostZoom, Math.max(leastZoom, Math.min(zoom, most)));
    camera.x = area.middle.x;
    camera.y = area.middle.y;
    if (base !== null) {
        const bottom = Math.max(base + below / camera.zoom, area.bottom + frameBorder / camera.zoom);
        camera.y = bottom - camera.height / 2 / camera.zoom;
    }
}

/** Shows what the run is about: its bodies, walls and ground, and where the bodies go. */
function frameRun(camera, figures, part, i, motion) {
    const view = part.view;
    const rest = restBox(figures[0].parts[0], figures);
    const near = rest.grown(rest.width / 2, rest.height / 2);
    const moved = motion.moved(followedX(figures[0].parts[0], 0), 0).cut(near);
    const area = moved.isEmpty ? rest : rest.united(moved);
    const larger = Math.max(1, Math.min(camera.width / 680, camera.height / 520));
    const isLarge = view.room || view.tree || view.dusk;
    const most = view.ground !== undefined && !view.room ? 1.8 : isLarge ? 1.5 : 2.6;
    frameArea(camera, view, area, larger * most);
    followX(camera, part, i, 0.4, 0.4);
}

/** Moves the view sideways if the followed point is not between two shares of its width. */
function followX(camera, part, i, from, to) {
    if (part.view.followed < 0)
        return;
    const x = camera.at(part.x[part.view.followed][i], 0).x;
    camera.pan(Math.min(Math.max(x, from * camera.width), to * camera.width) - x, 0);
}
