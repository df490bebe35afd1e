package faultline.engine.metrics;

import faultline.geometry.Vector2;
import java.util.OptionalDouble;

/** Measures which share of the wall a robot has followed. */
sealed interface CoverageMeter permits Coverage, CoverageOnDemand {

    /** Notes that the robot's centre was at a point; one point a square centimetre is kept. */
    void visit(Vector2 centre);

    /** Returns the share so far, in [0, 1]; empty if nothing was passed. May be called again and again in a run. */
    OptionalDouble share();
}
