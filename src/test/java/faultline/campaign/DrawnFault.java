package faultline.campaign;

import faultline.sensor.Fault;
import faultline.sensor.FaultKind;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/** The kinds of fault of the survival study, each with the range that its number is drawn from. */
enum DrawnFault {
    OFF(FaultKind.OFF, 0, 0),
    STUCK(FaultKind.STUCK, 0, 0.8),
    STUCK_WANTED(FaultKind.STUCK, 0.25, 0.25),
    STUCK_AT_LAST(FaultKind.STUCK_AT_LAST, 0, 0),
    BIAS(FaultKind.BIAS, 0.03, 0.3),
    BIAS_NEAR(FaultKind.BIAS, -0.3, -0.03),
    SCALE_NEAR(FaultKind.SCALE, 0.5, 0.9),
    SCALE_FAR(FaultKind.SCALE, 1.1, 1.8),
    DRIFT_FAR(FaultKind.DRIFT, 0.002, 0.02),
    DRIFT_NEAR(FaultKind.DRIFT, -0.02, -0.002),
    NOISE(FaultKind.NOISE, 0.01, 0.1),
    QUANTISED(FaultKind.QUANTISED, 0.01, 0.1),
    DROPOUT(FaultKind.DROPOUT, 0.2, 0.98),
    BURSTS(FaultKind.BURSTS, 0.1, 1),
    DELAYED(FaultKind.DELAYED, 0.05, 0.5),
    SHORT_RANGE(FaultKind.SHORT_RANGE, 0.05, 0.4),
    NARROW_CONE(FaultKind.CONE, 0.5, 8),
    WIDE_CONE(FaultKind.CONE, 30, 60),
    GHOST(FaultKind.GHOST, 0.02, 0.5),
    CROSS_TALK(FaultKind.CROSS_TALK, 0.1, 0.9),
    SPECULAR_LOSS(FaultKind.SPECULAR_LOSS, 10, 60),
    TURNED_LEFT(FaultKind.MISALIGNED, 5, 30),
    TURNED_RIGHT(FaultKind.MISALIGNED, -30, -5);

    private final FaultKind kind;
    private final double min;
    private final double max;

    DrawnFault(FaultKind kind, double min, double max) {
        this.kind = kind;
        this.min = min;
        this.max = max;
    }

    /** Returns the kinds of a list of names with commas between them, or of {@code all}. */
    static List<DrawnFault> of(String names) {
        return names.equals("all")
                ? List.of(values())
                : Arrays.stream(names.split(",")).map(DrawnFault::valueOf).toList();
    }

    Fault draw(SplittableRandom random) {
        return kind.createFault(min + (max - min) * random.nextDouble());
    }
}
