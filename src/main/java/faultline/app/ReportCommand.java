package faultline.app;

import faultline.campaign.report.CampaignReport;
import faultline.campaign.run.CampaignFolder;
import faultline.io.AtomicFileGroup;
import faultline.scenario.xml.ScenarioException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** {@code report}: makes an HTML page of a campaign. */
final class ReportCommand {

    private final CommandOutput output;

    ReportCommand(CommandOutput output) {
        this.output = output;
    }

    int run(List<String> arguments) throws UsageException, ScenarioException, IOException {
        Arguments parsed = new Arguments(arguments, List.of("--out", "--table", "--jar"));
        if (parsed.files().size() != 1) {
            throw new UsageException("report takes the folder of one campaign, not "
                    + (parsed.files().isEmpty() ? "none" : parsed.files().size()));
        }
        Path target = parsed.outputOption("--out")
                .orElseThrow(() -> new UsageException("report needs --out FILE.html, the page that it writes"));
        Optional<Path> table = parsed.outputOption("--table");
        List<Path> targets = table.map(file -> List.of(target, file)).orElse(List.of(target));
        Path folder = Arguments.parsePath(parsed.files().get(0));
        List<Path> jars = ControllerOptions.addJar(parsed);
        Arguments.requireDistinct(jars, targets);
        CampaignReport report = new CampaignReport(folder);
        Arguments.requireDistinct(new CampaignFolder(folder).files(), targets);
        try (AtomicFileGroup files = new AtomicFileGroup()) {
            files.write(target, report.html(jars).getBytes(StandardCharsets.UTF_8));
            if (table.isPresent()) {
                files.write(table.get(), report.cellsCsv().getBytes(StandardCharsets.UTF_8));
            }
            files.commit();
        }
        output.println("report: " + target);
        table.ifPresent(file -> output.println("table: " + file));
        output.println("runs: " + report.runCount());
        return ExitCode.SUCCESS;
    }
}
