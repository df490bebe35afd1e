package faultline.gui.gallery;

import faultline.gui.document.BackgroundTasks;
import faultline.gui.document.TaskProgress;
import faultline.paint.surface.Palette;
import faultline.scenario.ShippedScenarios;
import java.awt.EventQueue;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** Loads the examples and renders their thumbnails, one by one, in the background. */
final class ExampleLoader {

    private final TaskProgress progress = new TaskProgress();

    /** Starts loading; callbacks are called on the event dispatch thread. */
    ExampleLoader(Palette palette, Consumer<Example> onLoaded, Consumer<Throwable> onFailed) {
        BackgroundTasks.perform(
                () -> {
                    for (String name : fileNames()) {
                        if (progress.isActive()) {
                            Example example = Example.load(name, palette);
                            EventQueue.invokeLater(() -> ifActive(() -> onLoaded.accept(example)));
                        }
                    }
                },
                () -> {},
                failure -> ifActive(() -> onFailed.accept(failure)));
    }

    private static List<String> fileNames() throws IOException {
        List<String> names = new ArrayList<>(ShippedScenarios.names());
        names.remove(ShippedScenarios.DEFAULT);
        names.add(0, ShippedScenarios.DEFAULT);
        return names;
    }

    private void ifActive(Runnable callback) {
        if (progress.isActive()) {
            callback.run();
        }
    }

    void cancel() {
        progress.cancel();
    }
}
