package faultline.external;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.engine.ControllerProviders;
import java.util.Map;

/**
 * Makes controllers in Java.
 *
 * @param name of their provider
 * @param settings for the provider
 */
record ProviderSource(String name, Map<String, String> settings) implements ControllerSource {

    @Override
    public Controller start(Run run) {
        return ControllerProviders.create(name, settings);
    }

    @Override
    public boolean limitsAnswerTime() {
        return false;
    }
}
