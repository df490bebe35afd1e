package faultline.paint.surface;

import java.util.List;

/** How a line is broken, so that lines are told apart in grey print as well. */
public enum DashPattern {
    /** Not broken. */
    SOLID(List.of()),
    /** Dashes. */
    DASHED(List.of(7.0, 4.0)),
    /** Dots. */
    DOTTED(List.of(1.5, 3.0)),
    /** Dashes and dots in turn. */
    DASH_DOT(List.of(8.0, 3.0, 1.5, 3.0));

    private final List<Double> lengths;

    DashPattern(List<Double> lengths) {
        this.lengths = lengths;
    }

    /**
     * Dashes and gaps in turn.
     *
     * @return pixels; empty for a line that is not broken
     */
    public List<Double> lengths() {
        return lengths;
    }
}
