// SPDX-License-Identifier: MIT
// How charts look: colours for light and dark screens, and one colour and symbol per selector.

export interface Theme {
  ink: string;
  quiet: string;
  grid: string;
  card: string;
  heat: string; // the strongest background behind text
  strong: string; // the strongest colour of what has no text in it
  colours: readonly string[]; // as strong as text has to be, as far apart as eight can be
}

export const kLight: Theme = {
  ink: "#1c2430",
  quiet: "#5a6675",
  grid: "#e3e8ee",
  card: "#ffffff",
  heat: "#7fb8d8",
  strong: "#06507d",
  colours: [
    "#0072b2", "#c34a00", "#007a56", "#b8408a", "#8a6100", "#6b52c8", "#7b4a36", "#5f6b76",
  ],
};

export const kDark: Theme = {
  ink: "#e6ebf2",
  quiet: "#9aa7b8",
  grid: "#323b48",
  card: "#1e242d",
  heat: "#2f6f97",
  strong: "#7cc7f2",
  colours: [
    "#56a8f5", "#ff8b4d", "#3fcf9f", "#f29ccb", "#f0c24a", "#b3a1ff", "#d0a58a", "#aeb8c2",
  ],
};

const kSymbols = ["circle", "square", "triangle", "diamond", "cross", "star", "wye"] as const;

/** What charts are drawn with. */
export interface Frame {
  width: number; // px
  theme: Theme;
  names: readonly string[]; // of all selectors, in a fixed order
  shown: ReadonlySet<string>;
}

export function colourOf({ names, theme }: Frame, name: string): string {
  return theme.colours[names.indexOf(name) % theme.colours.length]!;
}

/** Scales by which a selector has the same colour and symbol in every chart. */
export function scalesOf(frame: Frame) {
  const domain = [...frame.names];
  return {
    color: { domain, range: domain.map((name) => colourOf(frame, name)) },
    symbol: { domain, range: domain.map((_, i) => kSymbols[i % kSymbols.length]!) },
  };
}
