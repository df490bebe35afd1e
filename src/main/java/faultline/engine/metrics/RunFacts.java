package faultline.engine.metrics;

import faultline.control.ControllerState;
import faultline.world.Collision;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/** The facts of a run that expectations are compared with, during the run or at its end. */
public interface RunFacts {

    /** {@return the controller's last state} */
    ControllerState finalState();

    /** {@return all states that the controller passed through, in the order of their first appearance} */
    List<ControllerState> visitedStates();

    /** {@return the names of all states, in order, with blanks between them; a name with a blank is in quotes} */
    default String visitedNames() {
        return visitedStates().stream()
                .map(ControllerState::name)
                .map(name -> name.indexOf(' ') < 0 ? name : '"' + name + '"')
                .collect(Collectors.joining(" "));
    }

    /** {@return the robot's first collision, if there was one} */
    Optional<Collision> collision();

    /**
     * {@return the followed share of the wall that could be followed, in [0, 1]; empty if no wall was followed, or if
     * its path is too long}
     */
    OptionalDouble coverage();

    /** {@return whether the coverage is not known, because the path along the wall has too many places} */
    boolean isPathTooLong();

    /** {@return the distance error on straight walls, metres, root mean square; empty if none was followed} */
    OptionalDouble distanceRms();

    /**
     * {@return a number that is empty if it is NaN}
     *
     * @param value the number
     */
    static OptionalDouble ifNumber(double value) {
        return Double.isNaN(value) ? OptionalDouble.empty() : OptionalDouble.of(value);
    }
}
