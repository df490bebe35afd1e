package faultline.external;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.engine.ControllerProviders;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Loads a controller for each run from jars as they are when the run starts.
 *
 * @param name the name of the controller
 * @param jars the jar files
 * @param settings the settings for its provider
 */
record JarControllerSource(String name, List<Path> jars, Map<String, String> settings) implements ControllerSource {

    @Override
    public Controller start(RunConditions run) {
        return ControllerJars.callWith(jars, () -> ControllerProviders.create(name, settings));
    }

    @Override
    public boolean limitsAnswerTime() {
        return false;
    }
}
