package faultline.app;

import faultline.io.DidYouMean;
import faultline.paint.surface.SvgTheme;
import faultline.studies.Figures;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** {@code figures}: generates the figures of the paper and the studies. */
final class FiguresCommand {

    private final CommandOutput output;

    FiguresCommand(CommandOutput output) {
        this.output = output;
    }

    int run(List<String> arguments) throws UsageException, IOException {
        Arguments parsed = new Arguments(arguments, List.of("--out", "--theme"));
        if (!parsed.files().isEmpty()) {
            throw new UsageException("figures takes no file, only --out DIR and --theme light|dark|adaptive");
        }
        Path folder = parsed.fileOption("--out")
                .orElseThrow(() -> new UsageException("figures needs --out DIR, the folder that they go to"));
        SvgTheme theme = parseAppearance(parsed.value("--theme").orElse("adaptive"));
        try (TerminalProgress progress = TerminalProgress.on(output.err())) {
            Figures.writeAll(folder, theme, progress::update);
        }
        output.println("figures: " + folder);
        return ExitCode.SUCCESS;
    }

    private static SvgTheme parseAppearance(String text) throws UsageException {
        List<String> allowed = Arrays.stream(SvgTheme.values())
                .map(value -> value.name().toLowerCase(Locale.ROOT))
                .toList();
        if (!allowed.contains(text)) {
            throw UsageException.ofValue("--theme", text, "light, dark or adaptive" + DidYouMean.hint(text, allowed));
        }
        return SvgTheme.valueOf(text.toUpperCase(Locale.ROOT));
    }
}
