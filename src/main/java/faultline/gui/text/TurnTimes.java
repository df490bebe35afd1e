package faultline.gui.text;

/**
 * The times of an alignment turn as they are shown, in seconds. t_D and t_p are computed from the rounded F3 and F4, so
 * that a reader who applies eq. (4) to the shown times gets exactly the shown t_p.
 *
 * @param f3 the time of frame F3, to a millisecond
 * @param f4 the time of frame F4, to a millisecond
 * @param tD the time between them, to a millisecond
 * @param tP half of it, to a tenth of a millisecond
 */
public record TurnTimes(String f3, String f4, String tD, String tP) {

    /** Returns the texts of two times, seconds. */
    public static TurnTimes of(double f3, double f4) {
        long first = Math.round(1000 * f3);
        long second = Math.round(1000 * f4);
        // eq. (4): t_p = t_D / 2
        return new TurnTimes(
                NumberText.format("%.3f", first / 1000.0),
                NumberText.format("%.3f", second / 1000.0),
                NumberText.format("%.3f", (second - first) / 1000.0),
                NumberText.format("%.4f", (second - first) / 2000.0));
    }
}
