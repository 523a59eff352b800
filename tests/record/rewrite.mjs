// Writes a recording again with the writer that others wrote (@mcap/core), as their tools do: without chunks, or
// compressed by lz4 (lz4js). Channels and schemas get other numbers; metadata comes last.
//   node rewrite.mjs FOLDER_OF_NODE_MODULES FROM.mcap TO.mcap none|lz4
import {createRequire} from 'node:module';
import fs from 'node:fs';
const require = createRequire(process.argv[2] + '/x.js');
const {McapStreamReader, McapWriter} = require('@mcap/core');
const fzstd = require('fzstd');
const lz4 = require('lz4js');

const [from, to, how] = process.argv.slice(3);
const file = fs.openSync(to, 'w');
let size = 0n;
const writable = {position: () => size, write: async bytes => { fs.writeSync(file, bytes); size += BigInt(bytes.length); }};
const writer = new McapWriter({writable, useChunks: how !== 'none', compressChunk: bytes => ({compression: 'lz4', compressedData: lz4.compress(bytes)})});
await writer.start({profile: '', library: 'rewrite.mjs'});

const reader = new McapStreamReader({decompressHandlers: {zstd: (bytes, length) => fzstd.decompress(bytes, new Uint8Array(Number(length)))}});
reader.append(fs.readFileSync(from));
const schemas = new Map(), channels = new Map(), ids = new Map(), metadata = [];
for (let record; (record = reader.nextRecord());) {
  if (record.type === 'Schema') schemas.set(record.id, record);
  else if (record.type === 'Channel') channels.set(record.id, record);
  else if (record.type === 'Metadata') metadata.push(record);
  else if (record.type === 'Message') {
    if (!ids.has(record.channelId)) {
      const {topic, schemaId, messageEncoding, metadata: about} = channels.get(record.channelId);
      const {name, encoding, data} = schemas.get(schemaId);
      ids.set(record.channelId, await writer.registerChannel({topic, messageEncoding, metadata: about, schemaId: await writer.registerSchema({name, encoding, data})}));
    }
    await writer.addMessage({...record, channelId: ids.get(record.channelId)});
  }
}
for (const {name, metadata: entries} of metadata) await writer.addMetadata({name, metadata: entries});
await writer.end();
