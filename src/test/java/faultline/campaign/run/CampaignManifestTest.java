package faultline.campaign.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class CampaignManifestTest {

    /** As written by all versions, without some members. */
    private static final String TEXT =
            """
            {
              "format": "faultline-campaign-1",
              "program_sha256": "",
              "java": "17.0.9+9",
              "name": "A \\"small\\" one \\u0007",
              "scenarios": [],
              "controllers": [
                {"name": "mine", "jar_sha256": "11"},
                {"name": "other", "jar_sha256": "22"}
              ],
              "runs": 1000000,
              "shard": "2/4",
              "columns": [
                {"name": "run", "unit": "", "meaning": "number, from 0"}
              ]
            }
            """;

    private static final CampaignManifest MANIFEST = CampaignManifest.parse(TEXT);

    private static CampaignManifest with(String part, String replacement) {
        assertTrue(TEXT.contains(part));
        return CampaignManifest.parse(TEXT.replace(part, replacement));
    }

    @Test
    void aManifestIsWrittenAsItWasRead() {
        assertEquals(TEXT, MANIFEST.text());
        assertEquals(TEXT.replace("2/4", "1/1"), MANIFEST.with(Shard.ALL).text());
        assertEquals(
                TEXT.replace("\"17.0.9+9\"", "null"),
                with("\"17.0.9+9\"", "null").text());
    }

    @Test
    void partsJavaVersionsAndDescriptionsOfColumnsMayDiffer() {
        assertTrue(MANIFEST.isSameCampaign(with("17.0.9+9", "21")));
        assertTrue(MANIFEST.isSameCampaign(with("2/4", "1/2")));
        assertTrue(MANIFEST.isSameCampaign(with("number, from 0", "number of the run")));
        assertFalse(MANIFEST.isSameCampaign(with("1000000", "1000001")));
        assertFalse(MANIFEST.isSameCampaign(with("\"program_sha256\": \"", "\"program_sha256\": \"abc")));
        assertFalse(MANIFEST.isSameCampaign(with("\"22\"", "\"23\"")));
    }

    @Test
    void theJarsOfControllersThatAreNotUsedMayDiffer() {
        CampaignManifest built = with("\"22\"", "\"23\"");
        assertTrue(MANIFEST.hasSameRuns(built, List.of("mine")));
        assertFalse(MANIFEST.hasSameRuns(built, List.of("mine", "other")));
        CampaignManifest without = with(",\n    {\"name\": \"other\", \"jar_sha256\": \"22\"}", "");
        assertTrue(MANIFEST.hasSameRuns(without, List.of("mine")));
        assertTrue(without.hasSameRuns(built, List.of("mine", "wall-follower")));
        CampaignManifest none = with(TEXT.substring(TEXT.indexOf("  \"contr"), TEXT.indexOf("  \"runs")), "");
        assertTrue(none.hasSameRuns(built, List.of()));
        assertFalse(none.hasSameRuns(built, List.of("mine")));
    }

    @Test
    void onlyAPartThatExistsIsOne() {
        assertEquals(Optional.of(new Shard(2, 4)), MANIFEST.shard());
        assertEquals(Optional.empty(), with("2/4", "5/4").shard());
        assertEquals(Optional.empty(), with("\"2/4\"", "2").shard());
        assertEquals(Optional.empty(), CampaignManifest.parse("7").shard());
    }

    @Test
    void textThatIsNoManifestHasNoMembers() {
        for (String text : List.of("", "[]", "{\"name\": }", "\uFFFD")) {
            assertEquals(CampaignManifest.parse("{}"), CampaignManifest.parse(text));
        }
    }
}
