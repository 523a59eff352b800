// Reads a recording with the readers that others wrote (@mcap/core and Foxglove's for ROS 2's messages), and prints what it saw.
//   node read.mjs FOLDER_OF_NODE_MODULES FILE.mcap
import {createRequire} from 'node:module';
import fs from 'node:fs';
const require = createRequire(process.argv[2] + '/x.js');
const {McapIndexedReader, McapStreamReader} = require('@mcap/core');
const {MessageReader} = require('@foxglove/rosmsg2-serialization');
const {parse} = require('@foxglove/rosmsg');
const fzstd = require('fzstd');

const bytes = fs.readFileSync(process.argv[3]);
const decompressHandlers = {zstd: (from, size) => fzstd.decompress(from, new Uint8Array(Number(size)))};
const readers = new Map();
function read(channel, schema, data) {
  if (!readers.has(channel.id)) readers.set(channel.id, new MessageReader(parse(new TextDecoder().decode(schema.data), {ros2: true})));
  return readers.get(channel.id).readMessage(data);
}

// By the index, as a viewer does: every checksum of a chunk and the one of the summary are compared.
async function indexed() {
  const readable = {size: async () => BigInt(bytes.length), read: async (at, n) => new Uint8Array(bytes.buffer, bytes.byteOffset + Number(at), Number(n))};
  const file = await McapIndexedReader.Initialize({readable, decompressHandlers});
  const count = {}, last = {};
  let messages = 0;
  for await (const m of file.readMessages({validateCrcs: true})) {
    const channel = file.channelsById.get(m.channelId);
    last[channel.topic] = read(channel, file.schemasById.get(channel.schemaId), m.data);
    count[channel.topic] = (count[channel.topic] ?? 0) + 1;
    ++messages;
  }
  if (BigInt(messages) !== file.statistics.messageCount) throw new Error(`the summary counts ${file.statistics.messageCount} messages`);
  return {how: 'indexed', messages, chunks: file.chunkIndexes.length, count, last};
}

// From the beginning: also a file that was cut off.
function streamed() {
  const file = new McapStreamReader({decompressHandlers, validateCrcs: true});
  let messages = 0, ended = true;
  try {
    file.append(bytes);
    for (let record; (record = file.nextRecord());) if (record.type === 'Message') ++messages;
    ended = file.done();
  } catch (e) { ended = String(e); }
  return {how: 'streamed', messages, ended};
}

let seen;
try { seen = await indexed(); } catch (e) { seen = {how: 'indexed', error: String(e)}; }
console.log(JSON.stringify([seen, streamed()], (_, v) => typeof v === 'bigint' ? Number(v) : v));
