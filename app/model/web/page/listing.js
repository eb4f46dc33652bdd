// Shows the listing, with the values that the frame has set beside their lines.

const keywords = new Set(["if", "else", "for", "while", "do", "return", "break", "continue", "const", "true", "false",
                          "and", "or", "not"]);
const typeNames = new Set(["void", "double", "int", "bool", "Vec2", "Body", "Creature", "Stick", "auto"]);

/** Returns the parts of a line of code with their colours. */
function coloured(code) {
    const pattern = /(\/\/.*$)|([A-Za-z_]\w*)|(\d+\.?\d*(?:e[+-]?\d+)?)/g;
    const nodes = [];
    let end = 0;
    for (const match of code.matchAll(pattern)) {
        const [text, comment, word] = match;
        const kind = comment ? "comment" : !word ? "number" : keywords.has(word) ? "keyword"
                                                          : typeNames.has(word) ? "type" : "";
        if (!kind)
            continue;
        nodes.push(code.slice(end, match.index), make("span", { class: kind }, text));
        end = match.index + text.length;
    }
    nodes.push(code.slice(end));
    return nodes;
}

class Listing {
    constructor(listing) {
        this.rows = new Map();
        const lines = listing.text.replace(/\n$/, "").split("\n");
        this.element = make("ol", { class: "listing", tabindex: "0" }, ...lines.map((code, k) => {
            const value = make("span", { class: "value" });
            const row = make("li", {}, make("code", {}, ...coloured(code)), value);
            this.rows.set(k + 1, { row, value });
            return row;
        }));
        this.lines = listing.lines.map((line) => {
            let at = 0;
            return { ...this.rows.get(line.line), number: line.line, texts: line.texts,
                     at: line.steps.map((step) => (at += step)) };
        }).filter((line) => line.row);
    }

    /** Returns the text beside a line of the listing (from 1) at frame `index` of the page. */
    textAt(number, index) {
        const line = this.lines.find((one) => one.number === number);
        return line ? line.texts[textsBefore(line, index) - 1] ?? "" : "";
    }

    show(index) {
        for (const line of this.lines) {
            const count = textsBefore(line, index);
            const isChanged = index > 0 && line.at[count - 1] === index;
            if (count !== line.shown)
                line.value.textContent = line.texts[count - 1] ?? "";
            if (isChanged !== line.isChanged)
                line.row.classList.toggle("changed", isChanged);
            Object.assign(line, { shown: count, isChanged });
        }
    }
}

/** Returns how many of the texts of a line come up to frame `index` of the page. */
function textsBefore(line, index) {
    let low = 0;
    let high = line.at.length;
    while (low < high) {
        const middle = (low + high) >> 1;
        if (line.at[middle] <= index)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
