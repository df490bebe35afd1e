package faultline.control.wallfollower;

import faultline.sensor.Reading;

/**
 * The range rule: F3 is the first sample with the wall, F4 the first without it. Both are late by up to one control
 * period. A wall that is in range when the spin starts has to leave it first.
 */
final class RangeEdgeTimer extends EdgeTimer {

    private boolean outOfRange;
    private double firstSeen = Double.NaN;
    private double lastReading;
    private double lastClock;

    @Override
    void start(double margin, double noise, boolean known, double step) {
        super.start(margin, noise, known, step);
        outOfRange = false;
        firstSeen = Double.NaN;
    }

    @Override
    void updateNoise(double noise, boolean known) {
        // Each sample counts separately.
    }

    @Override
    void addApproachSample(double clock, double reading, double rolled) {
        if (reading == Reading.NOTHING) {
            outOfRange = true;
            firstSeen = Double.NaN;
        } else if (outOfRange && Double.isNaN(firstSeen)) {
            firstSeen = clock;
        }
    }

    @Override
    boolean reachesWall() {
        return !Double.isNaN(firstSeen);
    }

    @Override
    void addPassSample(double clock, double reading) {
        lastClock = clock;
        lastReading = reading;
    }

    @Override
    boolean leavesWall() {
        if (lastReading < Reading.NOTHING) {
            return false;
        }
        setEdges(firstSeen, lastClock);
        return true;
    }
}
