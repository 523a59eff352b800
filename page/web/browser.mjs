// Debian's Chromium, headless, with a graphics card in software. It puts pictures together without that card:
// on a busy machine it would give a page a few pictures a second only, whatever the page does.
import puppeteer from 'puppeteer-core';

export const launch = () => puppeteer.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  headless: true,
  protocolTimeout: 600_000,
  timeout: 120_000,
  args: ['--no-sandbox', '--disable-gpu-compositing', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--allow-file-access-from-files', '--hide-scrollbars'],
});
