// Numbers as they are read.

const MINUS = "−";

/** A few digits, no trailing zeros, powers of ten where there are many zeros. */
export function short(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  if (size !== 0 && (size < 1e-3 || size >= 1e6)) {
    const [mantissa, power] = value.toExponential(Math.max(digits - 2, 0)).split("e");
    return `${String(Number(mantissa))}e${String(Number(power))}`.replaceAll("-", MINUS);
  }
  return String(Number(value.toPrecision(digits))).replace("-", MINUS);
}

export function fixed(value: number, decimals: number): string {
  if (!Number.isFinite(value)) return "–";
  const text = value.toFixed(decimals);
  // No minus before zeros.
  return Number(text) === 0 ? text.replace("-", "") : text.replace("-", MINUS);
}

export const seconds = (t: number): string => `${fixed(t, 2)} s`;
