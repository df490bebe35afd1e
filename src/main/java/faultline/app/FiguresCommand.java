package faultline.app;

import faultline.app.figures.Figures;
import faultline.paint.plot.Appearance;
import faultline.scenario.Quoting;
import faultline.scenario.Spelling;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** {@code figures}: makes the paper's figures and studies anew. */
final class FiguresCommand {

    private static final int BAR = 40;

    private final Console console;

    FiguresCommand(Console console) {
        this.console = console;
    }

    int run(List<String> arguments) throws UsageException, IOException {
        Arguments sorted = new Arguments(arguments, List.of("--out", "--theme"));
        if (!sorted.files().isEmpty()) {
            throw new UsageException("figures takes no file, only --out DIR and --theme light|dark|adaptive");
        }
        Path folder = sorted.file("--out").orElseThrow(() -> new UsageException("figures needs --out DIR, the folder that they go to"));
        Figures.make(folder, appearance(sorted.value("--theme").orElse("adaptive")), this::show);
        console.tell("figures: " + folder);
        return ExitCode.DONE;
    }

    private static Appearance appearance(String text) throws UsageException {
        List<String> allowed = Arrays.stream(Appearance.values()).map(value -> value.name().toLowerCase(Locale.ROOT)).toList();
        if (!allowed.contains(text)) {
            throw new UsageException("--theme is " + Quoting.quoted(text) + ", allowed is light, dark or adaptive" + Spelling.hint(text, allowed));
        }
        return Appearance.valueOf(text.toUpperCase(Locale.ROOT));
    }

    /** A bar that grows in its line. */
    private void show(int done, int all) {
        int filled = BAR * done / all;
        console.err().print("\r[" + "#".repeat(filled) + ".".repeat(BAR - filled) + "] " + done + "/" + all + (done == all ? "\n" : ""));
        console.err().flush();
    }
}
