package faultline.app;

import faultline.app.figures.Figures;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** {@code figures}: makes the paper's figures and studies anew. */
final class FiguresCommand {

    private static final int BAR = 40;

    private final Console console;

    FiguresCommand(Console console) {
        this.console = console;
    }

    int run(List<String> arguments) throws UsageException, IOException {
        Arguments sorted = new Arguments(arguments, List.of("--out"));
        if (!sorted.files().isEmpty()) {
            throw new UsageException("figures takes no file, only --out DIR");
        }
        Path folder = sorted.file("--out").orElseThrow(() -> new UsageException("figures needs --out DIR, the folder that they go to"));
        Figures.make(folder, this::show);
        console.tell("figures: " + folder);
        return ExitCode.DONE;
    }

    /** A bar that grows in its line. */
    private void show(int done, int all) {
        int filled = BAR * done / all;
        console.err().print("\r[" + "#".repeat(filled) + ".".repeat(BAR - filled) + "] " + done + "/" + all + (done == all ? "\n" : ""));
        console.err().flush();
    }
}
