package faultline.campaign.run;

import faultline.campaign.plan.CampaignPlan;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Finds the files that a campaign would replace or delete in a folder without a manifest, which no campaign has
 * written. A process that was killed before it wrote the manifest has left copies of the plan's files, and a merge also
 * its tables and replays; those are not such files.
 */
final class OtherFiles {

    private final CampaignFolder folder;
    private final CampaignPlan plan;
    /** Whether a merge of this campaign was interrupted here; it writes this table first. */
    private final boolean merged;

    private OtherFiles(CampaignFolder folder, CampaignPlan plan) throws IOException {
        this.folder = folder;
        this.plan = plan;
        merged = begins(folder.runs(), ResultColumns.header(plan));
    }

    /** Throws an exception if there is such a file in a folder without a manifest. */
    static void requireNone(CampaignFolder folder, CampaignPlan plan) throws IOException {
        Optional<Path> found = new OtherFiles(folder, plan).find();
        if (found.isPresent()) {
            throw new IOException(found.get() + ": the campaign would replace or delete this file,"
                    + " and the folder has no campaign.json; use another folder");
        }
    }

    private Optional<Path> find() throws IOException {
        List<Path> found = new ArrayList<>();
        if (Files.exists(folder.runs()) && !merged) {
            found.add(folder.runs());
        }
        if (Files.exists(folder.timing()) && !(merged && begins(folder.timing(), RunTable.TIMING_HEADER))) {
            found.add(folder.timing());
        }
        Stream.of(folder.plan(), folder.replays())
                .filter(inside -> Files.exists(inside) && !Files.isDirectory(inside))
                .forEach(found::add);
        for (Map.Entry<String, byte[]> copy : plan.files().copies().entrySet()) {
            Path file = folder.plan().resolve(copy.getKey());
            if (Files.exists(file) && !hasContent(file, copy.getValue())) {
                found.add(file);
            }
        }
        if (!merged && Files.isDirectory(folder.replays())) {
            try (Stream<Path> files = Files.list(folder.replays())) {
                files.filter(WorstRuns::isReplay).sorted().findFirst().ifPresent(found::add);
            }
        }
        return found.stream().findFirst();
    }

    private static boolean begins(Path table, String header) throws IOException {
        if (Files.notExists(table)) {
            return false;
        }
        try (LineReader in = new LineReader(table)) {
            return in.next().equals(header);
        }
    }

    private static boolean hasContent(Path file, byte[] content) throws IOException {
        return Files.isRegularFile(file)
                && Files.size(file) == content.length
                && Arrays.equals(Files.readAllBytes(file), content);
    }
}
