// Shows the angle of an arrow of the scene: its right triangle in the scene, and the unit circle on a card.

const circleRadius = 44; // px

/** Returns the arrow of a scene whose angle is shown, in px of the scene; null if there is none. */
function angleArrow(part, i) {
    const { angle, tree } = part.view;
    if (!angle)
        return null;
    const from = { x: part.x[angle.from][i], y: part.y[angle.from][i] };
    if (angle.to >= 0)
        return { from, to: { x: part.x[angle.to][i], y: part.y[angle.to][i] } };
    const turn = part.angle[angle.from][i] * Math.PI / 180;
    const length = tree.length[angle.from];
    return { from, to: { x: from.x + length * Math.cos(turn), y: from.y + length * Math.sin(turn) } };
}

/** Draws the triangle of the arrow. Returns its sides. */
function drawTriangle(scene) {
    const arrow = angleArrow(scene.part, scene.i);
    if (!arrow)
        return [];
    const { pen, camera, colors } = scene;
    const from = camera.at(arrow.from.x, arrow.from.y);
    const to = camera.at(arrow.to.x, arrow.to.y);
    const corner = { x: to.x, y: from.y };
    useStroke(pen, colors.ink2, 1.2);
    line(pen, from, to);
    useStroke(pen, colors.ink, 3);
    pen.lineCap = "butt";
    line(pen, from, corner);
    useStroke(pen, colors.ink, 3, [4, 3]);
    line(pen, corner, to);
    pen.setLineDash([]);
    return [[from, to], [from, corner], [corner, to]];
}

/** Makes an element of a drawing. */
function makeShape(name, attributes = {}, ...children) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    setAttributes(element, attributes);
    element.append(...children);
    return element;
}

function setAttributes(element, attributes) {
    for (const [key, value] of Object.entries(attributes))
        element.setAttribute(key, value);
}

/** The card with the circle, the numbers of its triangle, and Pythagoras. */
class UnitCircle {
    constructor(words) {
        this.words = words;
        this.axis = makeShape("line", { class: "thin", x2: circleRadius + 6 });
        this.arc = makeShape("path", { class: "arc" });
        this.arrow = makeShape("line", { class: "long" });
        this.beside = makeShape("line", { class: "side" });
        this.opposite = makeShape("line", { class: "side dashed" });
        this.tip = makeShape("circle", { class: "tip", r: 3 });
        const picture = makeShape("svg", { class: "circle", viewBox: "-55 -55 110 110", "aria-hidden": "true" },
                                  makeShape("circle", { class: "thin", r: circleRadius }), this.axis, this.arc, this.arrow,
                                  this.beside, this.opposite, this.tip);
        const sample = (kind) => makeShape("svg", { class: "sample", viewBox: "0 0 20 4", "aria-hidden": "true" },
                                           makeShape("line", { class: kind, x2: 20, y1: 2, y2: 2 }));
        this.rows = ["equation", "equation", "aside", "equation", "aside", "", "aside"].map((kind) => make("span", { class: kind }));
        const lines = this.rows.map((row, k) => {
            const before = k === 1 ? [sample("side")] : k === 3 ? [sample("side dashed")] : [];
            return make("p", {}, ...before, row);
        });
        this.element = make("div", { class: "card", role: "group", "aria-label": words.unitCircle }, picture,
                            make("div", { class: "lines" }, ...lines));
    }

    /** Gives the lines the width that the widest numbers need, so that the card is still while they change. */
    measure() {
        const lines = this.element.lastChild;
        lines.style.minWidth = "";
        this.show({ from: { x: 0, y: 0 }, to: { x: -888.8, y: -888.8 } });
        lines.style.minWidth = `${Math.ceil(lines.getBoundingClientRect().width)}px`;
        this.width = this.element.offsetWidth;
        this.height = this.element.offsetHeight;
    }

    /** Shows an arrow, from a place of the scene to another. */
    show({ from, to }) {
        const side = { x: to.x - from.x, y: to.y - from.y };
        const length = Math.hypot(side.x, side.y);
        const isThere = length > 0;
        for (const shape of [this.arc, this.arrow, this.beside, this.opposite, this.tip])
            shape.style.display = isThere ? "" : "none";
        const texts = isThere ? this.#texts(side, length) : [this.words.noLength, this.words.noDirection];
        this.rows.forEach((row, k) => {
            if (row.textContent !== (texts[k] ?? ""))
                row.textContent = texts[k] ?? "";
            row.parentElement.hidden = texts[k] === undefined;
        });
        if (!isThere)
            return;
        const x = circleRadius * side.x / length;
        const y = circleRadius * side.y / length;
        const share = 15 / circleRadius;
        setAttributes(this.arrow, { x2: x, y2: y });
        setAttributes(this.beside, { x2: x });
        setAttributes(this.opposite, { x1: x, x2: x, y2: y });
        setAttributes(this.tip, { cx: x, cy: y });
        setAttributes(this.arc, { d: `M15 0A15 15 0 0 ${y < 0 ? 0 : 1} ${share * x} ${share * y}` });
    }

    #texts(side, length) {
        const { words } = this;
        const angle = Math.atan2(side.y, side.x);
        const row = (name, px) => filled(words.sideIs, name, fixedNumber(px, 1), fixedNumber(length, 1),
                                         fixedNumber(px / length, 3));
        return [filled(words.angleIs, fixedNumber(angle * 180 / Math.PI, 1), fixedNumber(angle, 3)),
                row(words.cosine, side.x), words.beside, row(words.sine, side.y), words.opposite,
                filled(words.pythagoras, fixedNumber(Math.abs(side.x / length), 3), fixedNumber(Math.abs(side.y / length), 3)),
                words.down];
    }

    /** Returns the best corner of a view for the card: it keeps its own while that covers nothing. */
    cornerIn(camera, boxes) {
        const edge = 12;
        const right = camera.width - edge - this.width;
        const bottom = camera.height - 40 - this.height;
        const corners = [[right, 56], [edge, 56], [right, bottom], [edge, bottom]];
        const covered = ([x, y]) => boxes.reduce((sum, box) => {
            const both = box.cut(new Box(x, y, x + this.width, y + this.height));
            return both.isEmpty ? sum : sum + both.width * both.height;
        }, 0);
        const areas = corners.map(covered);
        this.corner ??= 0;
        if (areas[this.corner] > 0)
            this.corner = areas.indexOf(Math.min(...areas));
        return corners[this.corner];
    }
}
