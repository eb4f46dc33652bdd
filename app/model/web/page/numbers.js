// Unpacks the data of the page: see packed() and NumberColumns in app/model/web.

/** Returns the texts of the run, with a function that reads a column of numbers. */
async function unpack(text) {
    const packed = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    const size = new DataView(bytes.buffer).getUint32(0, true);
    const run = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + size)));
    const numbers = bytes.subarray(4 + size);
    run.column = (at, count) => readColumn(numbers, at, count);
    return run;
}

let decimalSign = "."; // of the language of the page

/** Returns a number with so many digits after the decimal sign, and never "-0". */
function fixedNumber(value, digits) {
    const text = Math.abs(value) < 1e7 ? value.toFixed(digits) : value.toExponential(1).replace("e+", "e");
    return (Number(text) === 0 ? text.replace("-", "") : text).replaceAll("-", "−").replace(".", decimalSign);
}

/** Returns a number with the digits that it needs, at most six. */
function plainNumber(value) {
    return String(Number(value.toPrecision(6))).replaceAll("-", "−").replace(".", decimalSign);
}

/** Returns `count` numbers of the column at byte `at`. */
function readColumn(bytes, at, count) {
    const view = new DataView(bytes.buffer, bytes.byteOffset);
    const values = new Float64Array(count);
    const kind = bytes[at++];
    if (kind === 0) {
        for (let i = 0; i < count; ++i)
            values[i] = view.getFloat64(at + 8 * i, true);
        return values;
    }
    if (kind === 1) {
        for (let i = 0; i < count; ++i)
            values[i] = view.getFloat32(at + 4 * i, true);
        return values;
    }
    const unit = 2 ** -kind;
    let last = 0;
    let step = 0;
    for (let i = 0; i < count; ++i) {
        let code = 0;
        let factor = 1;
        let byte = 0;
        do { // bit operations would cut the number to 32 bits
            byte = bytes[at++];
            code += (byte & 127) * factor;
            factor *= 128;
        } while (byte > 127);
        step += code % 2 === 0 ? code / 2 : -(code + 1) / 2;
        last += step;
        values[i] = last * unit;
    }
    return values;
}
