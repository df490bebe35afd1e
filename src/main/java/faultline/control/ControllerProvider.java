package faultline.control;

import java.util.Map;

/**
 * Makes controllers that are written in Java and are not part of the program. A class on the class path is found by
 * {@link java.util.ServiceLoader} if the file {@code META-INF/services/faultline.control.ControllerProvider} names it.
 */
public interface ControllerProvider {

    /**
     * {@return the name by which the command line and scenario files choose the controller, such as {@code bug2}} It
     * must not be blank, nor the name of another controller: {@code wall-follower}, {@code none}, {@code drive},
     * {@code extern} and {@code recorded} are built in.
     */
    String name();

    /**
     * {@return a new controller for one run} The same settings must give a controller that makes the same decisions.
     * One that is {@link AutoCloseable} is closed at the end of the run.
     *
     * @param settings the settings in the scenario file, by name; empty if there are none
     */
    Controller create(Map<String, String> settings);
}
