package faultline.control.wallfollower;

/**
 * Averages blocks of consecutive samples, in time and in reading. The noise shrinks by the square root of the block's
 * size.
 */
final class BlockAverage {

    private int size = 1;
    private int count;
    private double clock;
    private double reading;

    /** Starts a new average over blocks of a number of samples, at least one. */
    void start(int newSize) {
        size = newSize;
        count = 0;
    }

    /** Adds a sample, and returns whether it completes a block. */
    boolean add(double newClock, double newReading) {
        if (count == 0) {
            clock = 0;
            reading = 0;
        }
        clock += newClock / size;
        reading += newReading / size;
        count = (count + 1) % size;
        return count == 0;
    }

    /** Returns the time of the last completed block, seconds. */
    double clock() {
        return clock;
    }

    /** Returns the reading of the last completed block, metres; infinite if one of its samples is. */
    double reading() {
        return reading;
    }
}
