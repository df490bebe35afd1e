package faultline.sensor;

import faultline.geometry.Angles;

/**
 * Faults of the optics. They change what the sensor sees, except {@link ShortRange}, which only removes its readings
 * beyond a distance. Their angles are in degrees, as in files.
 */
public final class OpticalFault {

    private OpticalFault() {}

    /**
     * Dirt: the sensor sees nothing beyond a distance: file kind {@code short-range}.
     *
     * @param value that distance, metres
     */
    public record ShortRange(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the distance beyond which nothing is seen, metres
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#SHORT_RANGE}
         */
        public ShortRange {
            FaultKind.SHORT_RANGE.requireAllowed(value);
        }

        @Override
        public double apply(double reading, FaultContext context) {
            return reading > value ? Reading.NOTHING : reading;
        }
    }

    /**
     * Another field of view, narrower or wider: file kind {@code cone}.
     *
     * @param value the full angle, degrees
     */
    public record Cone(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the full angle, degrees
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#CONE}
         */
        public Cone {
            FaultKind.CONE.requireAllowed(value);
        }

        @Override
        public SensorSpec optics(SensorSpec spec) {
            return spec.withCone(StrictMath.toRadians(value));
        }
    }

    /**
     * A flat surface is seen only up to an angle of incidence, as if it were glossy: file kind {@code specular-loss}.
     *
     * @param value that angle from the normal, degrees
     */
    public record SpecularLoss(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the greatest angle of incidence that is seen, from the normal, degrees
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#SPECULAR_LOSS}
         */
        public SpecularLoss {
            FaultKind.SPECULAR_LOSS.requireAllowed(value);
        }

        @Override
        public double specularAngle() {
            return StrictMath.toRadians(value);
        }
    }

    /**
     * The sensor has a wrong bearing: file kind {@code misaligned}.
     *
     * @param value the error of its bearing, degrees, positive to the left
     */
    public record Misaligned(double value) implements Fault {
        /**
         * Creates the fault.
         *
         * @param value the error of its bearing, degrees, positive to the left
         * @throws IllegalArgumentException if the value is outside the limits of {@link FaultKind#MISALIGNED}
         */
        public Misaligned {
            FaultKind.MISALIGNED.requireAllowed(value);
        }

        @Override
        public SensorSpec optics(SensorSpec spec) {
            return spec.withBearing(Angles.normalize(spec.bearing() + StrictMath.toRadians(value)));
        }
    }
}
