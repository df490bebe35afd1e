package faultline.paint.surface;

import java.util.List;

/** The dash pattern of a line. It distinguishes lines in print without colours. */
public enum DashPattern {
    /** A solid line. */
    SOLID(List.of()),
    /** Dashes. */
    DASHED(List.of(7.0, 4.0)),
    /** Dots. */
    DOTTED(List.of(1.5, 3.0)),
    /** Alternate dashes and dots. */
    DASH_DOT(List.of(8.0, 3.0, 1.5, 3.0));

    private final List<Double> lengths;

    DashPattern(List<Double> lengths) {
        this.lengths = lengths;
    }

    /** Returns the alternate lengths of dashes and gaps, pixels; empty for a solid line. */
    public List<Double> lengths() {
        return lengths;
    }
}
