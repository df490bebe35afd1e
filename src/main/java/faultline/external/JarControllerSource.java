package faultline.external;

import faultline.control.Controller;
import faultline.control.ControllerSource;
import faultline.control.ControllerSpec;
import faultline.control.Decision;
import faultline.control.Observation;
import faultline.engine.ControllerProviders;
import java.io.IOException;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Loads a controller from jars for each run and closes the jars at its end, because some systems do not let a file be
 * replaced while it is open.
 *
 * @param name the name of the controller
 * @param jars the jar files
 * @param settings the settings for its provider
 */
record JarControllerSource(String name, List<Path> jars, Map<String, String> settings) implements ControllerSource {

    @Override
    public Controller start(RunConditions run) {
        URLClassLoader loader = ControllerChoice.loader(jars);
        try {
            return new LoadedController(
                    ControllerChoice.withLoader(loader, () -> ControllerProviders.create(name, settings)), loader);
        } catch (RuntimeException | Error e) {
            try {
                loader.close();
            } catch (IOException alsoBroken) {
                e.addSuppressed(alsoBroken);
            }
            throw e;
        }
    }

    @Override
    public boolean limitsAnswerTime() {
        return false;
    }

    /** A controller with the loader of its classes. */
    @SuppressWarnings("try") // The caller reports every exception, an interruption too.
    private record LoadedController(Controller delegate, URLClassLoader loader) implements Controller, AutoCloseable {

        @Override
        public Decision decide(Observation observation) {
            return delegate.decide(observation);
        }

        @Override
        public String name() {
            return delegate.name();
        }

        @Override
        public void configure(ControllerSpec.BuiltIn settings) {
            delegate.configure(settings);
        }

        @Override
        public void close() throws Exception {
            try (loader) {
                if (delegate instanceof AutoCloseable closeable) {
                    closeable.close();
                }
            }
        }
    }
}
