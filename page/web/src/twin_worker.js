// The live twin in a thread of its own.
import { Twin } from './twin.js';

let twin = null;
self.onmessage = ({ data: { url, protocols, code } }) => {
  twin?.stop();
  twin = url ? new Twin(new WebSocket(url, protocols), code, (told) => self.postMessage(told)) : null;
};
