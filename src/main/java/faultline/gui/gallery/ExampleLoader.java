package faultline.gui.gallery;

import faultline.paint.surface.Palette;
import faultline.scenario.ShippedScenarios;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.SwingWorker;

/** Reads the examples and takes their pictures off the event dispatch thread, one by one. */
final class ExampleLoader extends SwingWorker<Void, Example> {

    /** Shown first, because it has a bit of everything. */
    private static final String FIRST_FILE = "office.xml";

    private final Palette palette;
    private final Consumer<Example> onLoaded;
    private final Consumer<Throwable> onFailed;

    ExampleLoader(Palette palette, Consumer<Example> loaded, Consumer<Throwable> failed) {
        this.palette = palette;
        this.onLoaded = loaded;
        this.onFailed = failed;
    }

    @Override
    protected Void doInBackground() throws IOException, ScenarioException {
        List<String> names = ShippedScenarios.names();
        for (String name : Stream.concat(Stream.of(FIRST_FILE), names.stream().filter(name -> !name.equals(FIRST_FILE)))
                .toList()) {
            if (isCancelled()) {
                break;
            }
            publish(Example.load(name, palette));
        }
        return null;
    }

    @Override
    protected void process(List<Example> examples) {
        if (!isCancelled()) {
            examples.forEach(onLoaded);
        }
    }

    @Override
    protected void done() {
        try {
            if (!isCancelled()) {
                get();
            }
        } catch (ExecutionException broken) {
            onFailed.accept(broken.getCause());
        } catch (InterruptedException broken) {
            Thread.currentThread().interrupt();
        }
    }
}
