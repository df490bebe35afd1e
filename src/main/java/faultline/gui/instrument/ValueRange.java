package faultline.gui.instrument;

import faultline.paint.chart.Axis;
import java.util.stream.DoubleStream;

/** The range of a chart's vertical axis, and the limits of a fixed one. */
record ValueRange(RangeKind kind, double low, double high) {

    /** The values and zero. */
    static final ValueRange FROM_ZERO = new ValueRange(RangeKind.FROM_ZERO, 0, 1);
    /** The values only, so that small changes of large values are visible. */
    static final ValueRange FITTED = new ValueRange(RangeKind.FITTED, 0, 1);

    private static final double MIN_SIZE = 1e-5;
    /** The greatest magnitude of a limit: there, labels of twelve digits still differ at the smallest size. */
    private static final double MAX_VALUE = 1e5;
    /** The minimum size of a fitted range as a share of its greatest value, so that a constant has a readable scale. */
    private static final double MIN_FITTED_SHARE = 0.01;

    /** The ways to choose a range. */
    enum RangeKind {
        FROM_ZERO,
        FITTED,
        FIXED
    }

    /** Returns a range with fixed limits, resized and moved as far as necessary for labels that can be read. */
    static ValueRange fixed(double low, double high) {
        double size = allowedSize(high - low);
        double start = Math.max(-MAX_VALUE, Math.min(MAX_VALUE - size, low));
        return new ValueRange(RangeKind.FIXED, start, start + size);
    }

    private static double allowedSize(double size) {
        return Math.max(MIN_SIZE, Math.min(2 * MAX_VALUE, size));
    }

    /** Returns the axis of some finite values. */
    Axis axis(String unit, double[] values) {
        if (kind == RangeKind.FIXED) {
            return Axis.linear(unit, low, high);
        }
        if (DoubleStream.of(values).allMatch(value -> value == 0)) {
            return Axis.linear(unit, 0, 1);
        }
        double greatest = DoubleStream.of(values)
                .map(Math::abs)
                .filter(Double::isFinite)
                .max()
                .orElse(0);
        return Axis.covering(
                unit,
                DoubleStream.concat(
                        kind == RangeKind.FROM_ZERO ? DoubleStream.of(0) : DoubleStream.empty(),
                        DoubleStream.of(values)),
                MIN_FITTED_SHARE * greatest);
    }

    /** Returns the range of an axis scaled by a factor, with the value at a share of it kept in place. */
    static ValueRange zoomed(Axis axis, double factor, double share) {
        double size = allowedSize((axis.high() - axis.low()) * factor);
        double low = axis.valueAt(share) - share * size;
        return fixed(low, low + size);
    }

    /** Returns the range of an axis moved by a share of its size. */
    static ValueRange moved(Axis axis, double share) {
        double by = share * (axis.high() - axis.low());
        return fixed(axis.low() + by, axis.high() + by);
    }
}
