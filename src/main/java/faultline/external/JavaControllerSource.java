package faultline.external;

import faultline.control.Controller;
import faultline.control.ControllerProvider;
import faultline.control.ControllerSource;
import faultline.engine.ControllerProviders;
import java.util.Map;

/**
 * Makes controllers in Java.
 *
 * @param provider the provider
 * @param settings the settings for the provider
 */
record JavaControllerSource(ControllerProvider provider, Map<String, String> settings) implements ControllerSource {

    @Override
    public Controller start(RunConditions run) {
        return ControllerProviders.create(provider, settings);
    }

    @Override
    public boolean limitsAnswerTime() {
        return false;
    }
}
