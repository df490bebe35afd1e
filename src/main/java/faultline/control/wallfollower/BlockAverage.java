package faultline.control.wallfollower;

/** Makes one sample of every so many, their mean in time and in reading. Noise shrinks by the root of their number. */
final class BlockAverage {

    private int size = 1;
    private int count;
    private double clock;
    private double reading;

    /** Starts anew, with the mean of so many samples, at least one. */
    void start(int newSize) {
        size = newSize;
        count = 0;
    }

    /** Takes a sample, and says whether that makes a mean complete. */
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

    /** The moment of the mean that was completed last, seconds. */
    double clock() {
        return clock;
    }

    /** The reading of the mean that was completed last, metres; infinite where one of its samples is. */
    double reading() {
        return reading;
    }
}
