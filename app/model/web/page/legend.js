// Explains the marks in the scene: what the length of an arrow stands for, the ghost, and onion skins.

class Legend {
    constructor(words) {
        this.words = words;
        const mark = (width, ...shapes) =>
            makeShape("svg", { viewBox: `0 0 ${width} 12`, width, height: 12, "aria-hidden": "true" }, ...shapes);
        const marks = {
            ghost: mark(24, makeShape("line", { class: "ghost", x1: 1, x2: 23, y1: 6, y2: 6 })),
            onion: mark(24, ...[0, 1, 2].map((k) => makeShape("circle", { class: `skin skin${k}`, cx: 6 + 6 * k, cy: 6, r: 4.5 }))),
            velocities: mark(40, makeShape("path", { class: "velocity", d: "M1 6H39M29 1L39 6L29 11" })),
            pulls: mark(40, makeShape("path", { class: "pull", d: "M1 6H29" }), makeShape("path", { class: "head", d: "M29 1L39 6L29 11z" })),
        };
        this.entries = Object.entries(marks).map(([name, shape]) => {
            const text = make("span");
            return { name, text, element: make("li", { hidden: "" }, shape, text) };
        });
        this.element = make("ul", { class: "legend", "aria-label": words.legend }, ...this.entries.map((one) => one.element));
    }

    /** Shows the entries that have a text. */
    show(texts) {
        for (const entry of this.entries) {
            const text = texts[entry.name] ?? "";
            if (text === entry.shown)
                continue;
            entry.shown = text;
            entry.text.textContent = text;
            entry.element.hidden = text === "";
        }
    }
}
