package faultline.paint.surface;

import java.awt.Color;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The background for which the colours of an SVG file are chosen. Pictures are drawn in the colours of the light theme.
 */
public enum SvgTheme {
    /** White. */
    LIGHT,
    /** Dark. */
    DARK,
    /** White on paper and by default; dark on screens whose user prefers dark colours. */
    ADAPTIVE;

    private static final Pattern COLOUR = Pattern.compile("(fill|stroke)=\"(#[0-9a-f]{6})\"");
    private static final Map<String, String> DARK_COLOURS = colourPairs();

    /** Returns the colour of the dark theme for each colour of the light theme. */
    private static Map<String, String> colourPairs() {
        Map<String, String> pairs = new LinkedHashMap<>();
        addPairs(pairs, ChartStyle.LIGHT.series(), ChartStyle.DARK.series());
        addPairs(pairs, ChartStyle.LIGHT.classes(), ChartStyle.DARK.classes());
        pairs.putIfAbsent(Palette.toHex(ChartStyle.LIGHT.grid()), Palette.toHex(ChartStyle.DARK.grid()));
        addPairs(
                pairs,
                ChartStyle.LIGHT.palette().colours(),
                ChartStyle.DARK.palette().colours());
        return pairs;
    }

    private static void addPairs(Map<String, String> pairs, List<Color> light, List<Color> dark) {
        for (int i = 0; i < light.size(); i++) {
            pairs.putIfAbsent(Palette.toHex(light.get(i)), Palette.toHex(dark.get(i)));
        }
    }

    /** Returns the text of an SVG file with the colours of this theme. */
    String apply(String svg) {
        return switch (this) {
            case LIGHT -> svg;
            case DARK -> COLOUR.matcher(svg).replaceAll(use -> use.group(1) + "=\"" + darkColour(use.group(2)) + "\"");
            case ADAPTIVE -> svg.replaceFirst("\n", "\n<style>" + styleSheet(svg) + "</style>\n");
        };
    }

    /** Returns the CSS rules that exchange the colours of pictures on screens whose user prefers dark colours. */
    public static String styleSheet(String svg) {
        return COLOUR.matcher(svg)
                .results()
                .map(MatchResult::group)
                .distinct()
                .sorted()
                .map(SvgTheme::rule)
                .collect(Collectors.joining("", "@media screen and (prefers-color-scheme: dark) {\n", "}"));
    }

    private static String rule(String use) {
        String attribute = use.substring(0, use.indexOf('='));
        String colour = use.substring(use.indexOf('#'), use.length() - 1);
        return "[" + use + "] {" + attribute + ": " + darkColour(colour) + "}\n";
    }

    private static String darkColour(String colour) {
        String dark = DARK_COLOURS.get(colour);
        if (dark == null) {
            throw new IllegalStateException(colour + " is no colour of the light theme");
        }
        return dark;
    }
}
