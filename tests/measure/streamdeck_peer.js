// streamdeck_peer.js FOLDER - npm's @elgato-stream-deck/core on a device that only listens
//
// It gets each key's pixels and must send the same reports. JPEG files are ours, taken from our
// reports, so those are the same but for what an encoder decides; what djpeg reads in them is
// compared with the pixels that the package would have encoded: to 38 dB at least, and 44.0 were
// the least that was seen.
// SPDX-License-Identifier: MIT
'use strict';
const fs = require('fs');
const path = require('path');
const { execFileSync } = require('child_process');
const folder = process.argv[2];
const { DEVICE_MODELS2 } = require('@elgato-stream-deck/core');
const { EventEmitter } = require('eventemitter3');

const MODELS = [['streamdeck-mini', 'mini'], ['streamdeck-mini', '6-module'],
    ['streamdeck-original', 'original'], ['streamdeck', 'originalv2'],
    ['streamdeck', 'original-mk2'], ['streamdeck', 'original-mk2-scissor'],
    ['streamdeck', '15-module'], ['streamdeck-xl', 'xl'], ['streamdeck-xl', '32-module'],
    ['streamdeck-neo', 'neo'], ['streamdeck-plus', 'plus']];

class Listener extends EventEmitter {
    reports = [];
    features = [];
    async close() {}
    async sendFeatureReport(data) { this.features.push(Buffer.from(data)); }
    async getFeatureReport(id, length) { return new Uint8Array(length); }
    async sendReports(reports) { this.reports.push(...reports.map((r) => Buffer.from(r))); }
    async getDeviceInfo() { return { path: 'none', productId: 0, vendorId: 0 }; }
    async getChildDeviceInfo() { return null; }
}

function readReports(name) {
    const data = fs.readFileSync(path.join(folder, name)), reports = [];
    for (let at = 0; at < data.length; at += 4 + data.readUInt32LE(at)) {
        reports.push(data.subarray(at + 4, at + 4 + data.readUInt32LE(at)));
    }
    return reports;
}

function readPpm(data) {
    const head = /^P6\s+(\d+)\s+(\d+)\s+255\s/.exec(data.subarray(0, 40).toString('latin1'));
    return { width: +head[1], height: +head[2], rgb: data.subarray(head[0].length) };
}

// Where a report of a JPEG file says that it is the last, how long its part is, and where that is.
const LAYOUT = { 0x07: [3, 4, 8], 0x0b: [3, 4, 8], 0x0c: [10, 13, 16] };

/** The JPEG files of our reports, in their order. */
function filesOf(reports) {
    const files = [];
    let parts = [];
    for (const report of reports) {
        const [last, bytes, at] = LAYOUT[report[1]];
        parts.push(report.subarray(at, at + report.readUInt16LE(bytes)));
        if (report[last]) {
            files.push(Buffer.concat(parts));
            parts = [];
        }
    }
    return files;
}

/** Of the pixels that the package would encode, 4 bytes each, and of what a decoder reads. */
function decibels(rgba, file) {
    const { rgb } = readPpm(execFileSync('djpeg', ['-ppm'], { input: file }));
    let sum = 0;
    for (let i = 0; i < rgb.length; i++) {
        sum += (rgb[i] - rgba[Math.floor(i / 3) * 4 + i % 3]) ** 2;
    }
    return sum === 0 ? Infinity : 10 * Math.log10(255 * 255 * rgb.length / sum);
}

function crop(picture, left, top, width, height) {
    const to = Buffer.alloc(3 * width * height);
    for (let y = 0; y < height; y++) {
        const from = 3 * ((top + y) * picture.width + left);
        picture.rgb.copy(to, 3 * y * width, from, from + 3 * width);
    }
    return to;
}

/** The nearest pixels of a part of the picture. */
function enlarged(picture, left, top, columns, rows, width, height) {
    const to = Buffer.alloc(3 * width * height);
    for (let i = 0; i < width * height; i++) {
        const x = left + Math.floor((i % width + 0.5) * columns / width);
        const y = top + Math.floor((Math.floor(i / width) + 0.5) * rows / height);
        picture.rgb.copy(to, 3 * i, 3 * (y * picture.width + x), 3 * (y * picture.width + x) + 3);
    }
    return to;
}

const LOWER = { neo: [96, 192, 192, 45, 248, 58], plus: [0, 240, 480, 60, 800, 100] };

async function compare(name, id) {
    const device = new Listener();
    const isJpeg = !['mini', '6-module', 'original'].includes(id);
    const ours = readReports(name + '.reports').slice(isJpeg ? 0 : 1); // the end of an image
    const files = isJpeg ? filesOf(ours) : [];
    let least = Infinity, next = 0;
    const encodeJPEG = async (rgba) => {
        const file = files[next++];
        least = Math.min(least, decibels(rgba, file));
        return file;
    };
    const deck = DEVICE_MODELS2[id].factory(device, { encodeJPEG });
    const picture = readPpm(fs.readFileSync(path.join(folder, name + '.ppm')));
    const [columns, rows, side, width, height] =
        fs.readFileSync(path.join(folder, name + '.size'), 'latin1').trim().split(' ').map(Number);
    for (let key = 0; key < columns * rows; key++) {
        const left = key % columns * side, top = Math.floor(key / columns) * side;
        const pixels = crop(picture, left, top, side, side);
        await deck.fillKeyBuffer(key, pixels, { format: 'rgb' });
    }
    if (id in LOWER) {
        await deck.fillLcd(0, enlarged(picture, ...LOWER[id]), { format: 'rgb' });
    }
    const same = ours.filter((r, i) => device.reports[i] && r.equals(device.reports[i])).length;
    device.features = [];
    await deck.setBrightness(70);
    await deck.resetToLogo();
    const features = readReports(name + '.features');
    const both = features.length === 2 && device.features.length === 2 &&
        features.every((r, i) => r.equals(device.features[i]));
    // The package has the gaps, but does not use them yet.
    const { KEY_SPACING_HORIZONTAL: across, KEY_SPACING_VERTICAL: down } = deck.deviceProperties;
    const gaps = { width: columns * (side + across) - across, height: rows * (side + down) - down };
    const fits = gaps.width === width && gaps.height === height;
    const good = same === ours.length && same === device.reports.length && both && fits &&
        least >= (isJpeg ? 38 : Infinity);
    console.log(`${good ? 'pass' : 'FAIL'} ${name}, as ${id}: ${same} of ${ours.length} reports ` +
        `(theirs: ${device.reports.length}) and ${both ? 'both' : 'not both'} feature reports are ` +
        `the same, ${isJpeg ? least.toFixed(1) + ' dB at least' : 'every pixel'}, with gaps ` +
        `${width}x${height}${fits ? '' : `, theirs ${gaps.width}x${gaps.height}`}`);
    return good;
}

(async () => {
    let good = true;
    for (const [name, id] of MODELS) {
        good = await compare(name, id) && good;
    }
    process.exit(good ? 0 : 1);
})();
