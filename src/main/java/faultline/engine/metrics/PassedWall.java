package faultline.engine.metrics;

/** How much of a wall a robot has passed. All lengths are in metres. */
final class PassedWall {

    private double length;
    private double passedLength;
    private double weightedPasses;

    /** Adds a piece to the wall. */
    void addLength(double pieceLength) {
        length += pieceLength;
    }

    /** Records a pass of a piece, and whether it is the first one. */
    void pass(double pieceLength, boolean first) {
        passedLength += first ? pieceLength : 0;
        weightedPasses += pieceLength;
    }

    /** Returns the length of the wall. */
    double length() {
        return length;
    }

    /** Returns the share that was passed, in [0, 1]; 0 of a wall without length. */
    double share() {
        return length > 0 ? Math.min(1, passedLength / length) : 0;
    }

    /** Returns how often the wall was passed, on average over its length; not a number if it has none. */
    double laps() {
        return weightedPasses / length;
    }
}
