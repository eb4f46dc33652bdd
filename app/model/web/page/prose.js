// Shows the text of a step, which is Markdown: paragraphs, headings, lists, code, **bold**, *italic*, `code` and links. It
// makes elements and texts only, so nothing in the text can act as HTML.

function inlineNodes(text) {
    const pattern = /(`+)(.+?)\1|\*\*(.+?)\*\*|\*(.+?)\*|\[([^\]]+)\]\([^)]*\)|\\([\\`*_[\](){}#+.!-])/gs;
    const nodes = [];
    let end = 0;
    for (const match of text.matchAll(pattern)) {
        nodes.push(text.slice(end, match.index));
        end = match.index + match[0].length;
        const [, , code, bold, italic, link, escaped] = match;
        if (code !== undefined)
            nodes.push(codeOf(code.trim()));
        else if (bold !== undefined)
            nodes.push(make("strong", {}, ...inlineNodes(bold)));
        else if (italic !== undefined)
            nodes.push(make("em", {}, ...inlineNodes(italic)));
        else
            nodes.push(...(link !== undefined ? inlineNodes(link) : [escaped]));
    }
    nodes.push(text.slice(end));
    return nodes;
}

/** Shows code that breaks at its spaces only, not inside "-=". */
function codeOf(code) {
    const words = code.split(" ").flatMap((word, k) => [k > 0 ? " " : "", make("span", {}, word)]);
    return make("code", {}, ...words);
}

function blockOf(text) {
    const lines = text.split("\n");
    if (text.startsWith("```"))
        return make("pre", {}, lines.slice(1).filter((line) => !line.startsWith("```")).join("\n"));
    const heading = /^#+ (.*)$/.exec(text);
    if (heading)
        return make("h3", {}, ...inlineNodes(heading[1]));
    const item = /^ {0,3}(?:[-*+]|(\d+)[.)]) +/;
    const first = item.exec(text);
    if (!first)
        return make("p", {}, ...inlineNodes(lines.join(" ")));
    const items = [];
    for (const one of lines) {
        if (item.test(one))
            items.push(one.replace(item, ""));
        else
            items[items.length - 1] += " " + one.trim();
    }
    return make(first[1] ? "ol" : "ul", {}, ...items.map((one) => make("li", {}, ...inlineNodes(one))));
}

function proseOf(text) {
    const blocks = text.replace(/\{#[^}]*\}/g, "").split(/\n\s*\n(?![ ]{4})/);
    return blocks.map((block) => block.trim()).filter(Boolean).map(blockOf);
}
