// Numbers, times and units as the page spells them.

export function short(value) {
  if (!Number.isFinite(value)) return String(value);
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e5)) return value.toExponential(2);
  return value.toFixed(size >= 100 ? 1 : size >= 10 ? 2 : 3);
}

export function age(seconds) {
  if (!(seconds >= -1e-6)) return 'none yet';
  return seconds < 1 ? `${Math.abs(Math.round(seconds * 1e3))} ms` : `${seconds.toFixed(1)} s`;
}

// "30 deg" as a number in the SI unit; what is no number is NaN.
export function parse(text, field) {
  const match = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?|nan|inf)\s*(.*?)\s*$/i.exec(text);
  if (!match) return { problem: `expected a number, got "${text}"` };
  const word = match[1].toLowerCase();
  const number = word === 'nan' ? NaN : word === 'inf' ? Infinity : Number(match[1]);
  if (!match[2]) return { value: number };
  const unit = (field.units ?? []).find((u) => u.text === match[2]);
  if (!unit) {
    const known = (field.units ?? []).map((u) => u.text).join(', ');
    return { problem: `unknown unit "${match[2]}"` + (known ? `, expected ${known}` : ': this parameter has none') };
  }
  return { value: number * unit.factor };
}

export function range(field) {
  const unit = field.unit ? ` ${field.unit}` : '';
  if (field.lower == null && field.upper == null) return field.unit ?? '';
  if (field.upper == null) return `at least ${field.lower}${unit}`;
  if (field.lower == null) return `at most ${field.upper}${unit}`;
  return `${field.lower} to ${field.upper}${unit}`;
}

// Colours that people with any kind of colour vision tell apart (Okabe and Ito), each with its own dash.
export const curves = [
  { light: '#0072b2', dark: '#56b4e9', dash: [] },
  { light: '#b25000', dark: '#e69f00', dash: [8, 4] },
  { light: '#00735a', dark: '#2fc79b', dash: [2, 3] },
  { light: '#a2407f', dark: '#e59ac6', dash: [10, 3, 2, 3] },
  { light: '#4d4d4d', dark: '#d0d0d0', dash: [4, 4] },
  { light: '#7a5c00', dark: '#f0e442', dash: [14, 4] },
];
