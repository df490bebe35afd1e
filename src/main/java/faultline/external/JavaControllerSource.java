package faultline.external;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.ControllerSource;
import faultline.engine.ControllerProviders;
import java.util.Map;

/**
 * Makes controllers in Java.
 *
 * @param name the name of the controller
 * @param provider the provider
 * @param settings the settings for the provider
 */
record JavaControllerSource(String name, ControllerProvider provider, Map<String, String> settings)
        implements ControllerSource {

    @Override
    public Controller start(RunConditions run) {
        return ControllerProviders.create(name, provider, settings);
    }

    @Override
    public boolean limitsAnswerTime() {
        return false;
    }
}
