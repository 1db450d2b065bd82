<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Clip</name>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>superior</translation>
    </message>
</context>
<context>
    <name>DocumentsController</name>
    <message>
        <source>PDF files (*.pdf)</source>
        <translation>PDF-Dateien (*.pdf)</translation>
    </message>
    <message>
        <source>XML files (*.xml)</source>
        <translation>XML-Dateien (*.xml)</translation>
    </message>
    <message>
        <source>STL files (*.stl)</source>
        <translation>STL-Dateien (*.stl)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>DoseOver</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 prescribed</source>
        <translation>%1 verschrieben</translation>
    </message>
    <message>
        <source>%1, the highest dose</source>
        <translation>%1, der höchsten Dosis</translation>
    </message>
    <message>
        <source>%1, as chosen</source>
        <translation>%1, wie gewählt</translation>
    </message>
    <message>
        <source>100 % = %1</source>
        <translation>100 % = %1</translation>
    </message>
    <message>
        <source>Dose: none was computed here</source>
        <translation>Dosis: Hier wurde keine berechnet</translation>
    </message>
    <message>
        <source>Dose: %1</source>
        <translation>Dosis: %1</translation>
    </message>
    <message>
        <source>%1, %2 % of %3</source>
        <translation>%1, %2 % von %3</translation>
    </message>
</context>
<context>
    <name>Fidelity</name>
    <message>
        <source>, values on cut faces only coarsely</source>
        <translation>, Werte auf Schnittflächen nur grob</translation>
    </message>
    <message>
        <source>, denoised</source>
        <translation>, entrauscht</translation>
    </message>
    <message>
        <source>, smoothed</source>
        <translation>, geglättet</translation>
    </message>
    <message>
        <source>, 1/%1 of the pixels each way</source>
        <translation>, 1/%1 der Pixel je Richtung</translation>
    </message>
    <message>
        <source>, %1 of %2 samples</source>
        <translation>, %1 von %2 Abtastungen</translation>
    </message>
    <message>
        <source>, complete</source>
        <translation>, vollständig</translation>
    </message>
    <message>
        <source>, converging</source>
        <translation>, wird besser</translation>
    </message>
    <message>
        <source>, parallel rays</source>
        <translation>, parallele Strahlen</translation>
    </message>
    <message>
        <source>, sharp centre traced %L1 s ago</source>
        <translation>, scharfe Mitte vor %L1 s verfolgt</translation>
    </message>
    <message numerus="yes">
        <source>Preview, sharpened in %n steps</source>
        <translation>
            <numerusform>Vorschau, in %n Schritt geschärft</numerusform>
            <numerusform>Vorschau, in %n Schritten geschärft</numerusform>
        </translation>
    </message>
    <message>
        <source>, coarse preview</source>
        <translation>, grobe Vorschau</translation>
    </message>
    <message numerus="yes">
        <source>, %n samples</source>
        <translation>
            <numerusform>, %n Abtastung</numerusform>
            <numerusform>, %n Abtastungen</numerusform>
        </translation>
    </message>
    <message>
        <source>, preview where it is less noisy</source>
        <translation>, Vorschau, wo sie weniger rauscht</translation>
    </message>
    <message>
        <source>Preview, estimated from the values</source>
        <translation>Vorschau, aus den Werten geschätzt</translation>
    </message>
</context>
<context>
    <name>FollowUpDialog</name>
    <message>
        <source>No date</source>
        <translation>Ohne Datum</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Ausgangsuntersuchung</translation>
    </message>
    <message>
        <source>Before the baseline</source>
        <translation>Vor der Ausgangsuntersuchung</translation>
    </message>
    <message>
        <source>CR: complete response</source>
        <translation>CR: komplette Remission</translation>
    </message>
    <message>
        <source>PR: partial response</source>
        <translation>PR: partielle Remission</translation>
    </message>
    <message>
        <source>SD: stable disease</source>
        <translation>SD: stabile Erkrankung</translation>
    </message>
    <message>
        <source>PD: progressive disease</source>
        <translation>PD: progrediente Erkrankung</translation>
    </message>
    <message>
        <source>NE: not all are measured</source>
        <translation>NE: nicht alle sind gemessen</translation>
    </message>
</context>
<context>
    <name>HeadsetWords</name>
    <message>
        <source>Shift</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Knife: on</source>
        <translation>Messer: an</translation>
    </message>
    <message>
        <source>Knife: off</source>
        <translation>Messer: aus</translation>
    </message>
    <message>
        <source>Hold: %1</source>
        <translation>Halte: %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Reset clips</source>
        <translation>Beschnitt weg</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Take picture</source>
        <translation>Bild aufnehmen</translation>
    </message>
    <message>
        <source>Other wrist</source>
        <translation>Andere Hand</translation>
    </message>
    <message>
        <source>Real size 1:1</source>
        <translation>Maßstab 1:1</translation>
    </message>
    <message>
        <source>%1 times real size</source>
        <translation>%1-mal wahre Größe</translation>
    </message>
    <message>
        <source>1/%1 of real size</source>
        <translation>1/%1 der wahren Größe</translation>
    </message>
    <message>
        <source>Before me</source>
        <translation>Vor mich</translation>
    </message>
    <message>
        <source>Quality: %1</source>
        <translation>Qualität: %1</translation>
    </message>
    <message>
        <source>fast</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>ausgewogen</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fein</translation>
    </message>
    <message>
        <source>Not for primary diagnosis</source>
        <translation>Nicht zur Primärdiagnose</translation>
    </message>
    <message>
        <source>Real size 1:1: a millimetre is a millimetre.</source>
        <translation>Maßstab 1:1: ein Millimeter ist ein Millimeter.</translation>
    </message>
    <message>
        <source>Before you, at real size 1:1.</source>
        <translation>Vor Ihnen, im Maßstab 1:1.</translation>
    </message>
    <message>
        <source>Nothing would be left to see: that was not done.</source>
        <translation>Es bliebe nichts zu sehen: das geschah nicht.</translation>
    </message>
    <message>
        <source>No more than six cuts: undo one, or reset the clips.</source>
        <translation>Höchstens sechs Schnitte: nehmen Sie einen zurück.</translation>
    </message>
    <message>
        <source>The headset has lost its place. Look around.</source>
        <translation>Das Headset weiß nicht, wo es ist. Sehen Sie umher.</translation>
    </message>
    <message>
        <source>Picture %1 is written.</source>
        <translation>Bild %1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Size is not calibrated</source>
        <translation>Größe ist nicht kalibriert</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Keys and Mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>About Macula</source>
        <translation>Über Macula</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Macula %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Path-traced anatomy from DICOM.&lt;/p&gt;&lt;p&gt;Not a medical device, and &lt;b&gt;not for primary diagnosis&lt;/b&gt;.&lt;/p&gt;&lt;p&gt;Licence: Apache-2.0.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Macula %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Pfadverfolgte Anatomie aus DICOM.&lt;/p&gt;&lt;p&gt;Kein Medizinprodukt und &lt;b&gt;nicht zur Primärdiagnose&lt;/b&gt;.&lt;/p&gt;&lt;p&gt;Lizenz: Apache-2.0.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>IsodoseEdits</name>
    <message>
        <source>Isodoses</source>
        <translation>Isodosen</translation>
    </message>
</context>
<context>
    <name>JoinQuestion</name>
    <message>
        <source>One series?</source>
        <translation>Eine Serie?</translation>
    </message>
    <message>
        <source> Are they one series?</source>
        <translation> Sind sie eine Serie?</translation>
    </message>
    <message>
        <source>If you join them, check that all of them are of one patient and one examination.</source>
        <translation>Wenn Sie sie verbinden, prüfen Sie, dass alle von einem Patienten und einer Untersuchung sind.</translation>
    </message>
    <message>
        <source>&amp;Join Them</source>
        <translation>&amp;Verbinden</translation>
    </message>
</context>
<context>
    <name>KeyBook</name>
    <message>
        <source>Only one key at a time can be taken, with Ctrl, Shift or Alt.</source>
        <translation>Es kann nur eine Taste auf einmal sein, mit Strg, Umschalt oder Alt.</translation>
    </message>
    <message>
        <source>%1 is used in panes, lists and fields. Take another key.</source>
        <translation>%1 wird in Bildfeldern, Listen und Feldern gebraucht. Nehmen Sie eine andere Taste.</translation>
    </message>
    <message>
        <source>This works in the picture, with one key alone. Take one without Ctrl, Shift or Alt.</source>
        <translation>Das wirkt im Bild mit einer Taste allein. Nehmen Sie eine ohne Strg, Umschalt oder Alt.</translation>
    </message>
    <message>
        <source>%1 is the key of “%2”. Change that one first, or take another key.</source>
        <translation>%1 ist die Taste von „%2“. Ändern Sie zuerst diese, oder nehmen Sie eine andere Taste.</translation>
    </message>
</context>
<context>
    <name>LinkQuestion</name>
    <message>
        <source>studies of a patient, whose ID is hidden with the names</source>
        <translation>Studien eines Patienten, dessen ID mit den Namen ausgeblendet ist</translation>
    </message>
    <message>
        <source>studies of the patient with the ID %1</source>
        <translation>Studien des Patienten mit der ID %1</translation>
    </message>
    <message>
        <source>studies of the patient with the ID %1 (issued by %2)</source>
        <translation>Studien des Patienten mit der ID %1 (vergeben von %2)</translation>
    </message>
    <message numerus="yes">
        <source>, the %n most recent</source>
        <translation>
            <numerusform>, die letzte</numerusform>
            <numerusform>, die letzten %n</numerusform>
        </translation>
    </message>
    <message>
        <source>, from %1 on</source>
        <translation>, ab %1</translation>
    </message>
    <message>
        <source>, up to %1</source>
        <translation>, bis %1</translation>
    </message>
    <message numerus="yes">
        <source>Macula would ask %n archives.</source>
        <translation>
            <numerusform>Macula würde %n Archiv fragen.</numerusform>
            <numerusform>Macula würde %n Archive fragen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Macula would ask the archive %1.</source>
        <translation>Macula würde das Archiv %1 fragen.</translation>
    </message>
    <message>
        <source>Macula would ask these archives: %1.</source>
        <translation>Macula würde diese Archive fragen: %1.</translation>
    </message>
    <message>
        <source>the study with the UID %1</source>
        <translation>die Studie mit der UID %1</translation>
    </message>
    <message numerus="yes">
        <source>%n studies by their UIDs</source>
        <translation>
            <numerusform>%n Studie anhand ihrer UID</numerusform>
            <numerusform>%n Studien anhand ihrer UIDs</numerusform>
        </translation>
    </message>
    <message>
        <source>the study with the accession number %1</source>
        <translation>die Studie mit der Accession-Nummer %1</translation>
    </message>
    <message numerus="yes">
        <source>%n studies by their accession numbers</source>
        <translation>
            <numerusform>%n Studie anhand ihrer Accession-Nummer</numerusform>
            <numerusform>%n Studien anhand ihrer Accession-Nummern</numerusform>
        </translation>
    </message>
    <message>
        <source>Fetch What a Link Asks For?</source>
        <translation>Abrufen, was ein Link verlangt?</translation>
    </message>
    <message>
        <source>A link asks Macula to open %1.</source>
        <translation>Ein Link verlangt, dass Macula Folgendes öffnet: %1.</translation>
    </message>
    <message>
        <source>Any web page can make such a link: fetch only what you expect.</source>
        <translation>Jede Webseite kann einen solchen Link enthalten: rufen Sie nur ab, was Sie erwarten.</translation>
    </message>
    <message>
        <source>&amp;Fetch</source>
        <translation>&amp;Abrufen</translation>
    </message>
</context>
<context>
    <name>Look</name>
    <message>
        <source>Path traced</source>
        <translation>Pfadverfolgt</translation>
    </message>
    <message>
        <source>Path traced, clear</source>
        <translation>Pfadverfolgt, klar</translation>
    </message>
</context>
<context>
    <name>Model</name>
    <message>
        <source>It goes on from where an earlier session left it.</source>
        <translation>Es macht weiter, wo eine frühere Sitzung aufgehört hat.</translation>
    </message>
    <message>
        <source>The graphics device has no room for it beside the volume: while a hand moves, small traced pictures are shown.</source>
        <translation>Das Grafikgerät hat neben dem Volumen keinen Platz dafür: während der Bewegung werden kleine verfolgte Bilder gezeigt.</translation>
    </message>
    <message>
        <source>It could not be made on this graphics device: while a hand moves, small traced pictures are shown.</source>
        <translation>Es konnte auf diesem Grafikgerät nicht erstellt werden: während der Bewegung werden kleine verfolgte Bilder gezeigt.</translation>
    </message>
    <message>
        <source>Preparing the preview</source>
        <translation>Vorschau wird vorbereitet</translation>
    </message>
    <message numerus="yes">
        <source>Preview of an earlier session, %n steps</source>
        <translation>
            <numerusform>Vorschau einer früheren Sitzung, %n Schritt</numerusform>
            <numerusform>Vorschau einer früheren Sitzung, %n Schritte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Preview sharpening, %n steps</source>
        <translation>
            <numerusform>Vorschau wird schärfer, %n Schritt</numerusform>
            <numerusform>Vorschau wird schärfer, %n Schritte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Preview not sharp yet, %n steps</source>
        <translation>
            <numerusform>Vorschau noch unscharf, %n Schritt</numerusform>
            <numerusform>Vorschau noch unscharf, %n Schritte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Preview sharp, %n steps</source>
        <translation>
            <numerusform>Vorschau scharf, %n Schritt</numerusform>
            <numerusform>Vorschau scharf, %n Schritte</numerusform>
        </translation>
    </message>
    <message>
        <source>No memory for a sharp preview</source>
        <translation>Kein Speicher für eine scharfe Vorschau</translation>
    </message>
    <message>
        <source>No sharp preview</source>
        <translation>Keine scharfe Vorschau</translation>
    </message>
    <message>
        <source>It began with the stored preview of other lights.</source>
        <translation>Sie hat mit der gespeicherten Vorschau einer anderen Beleuchtung begonnen.</translation>
    </message>
    <message>
        <source>It began with a preview that another version of Macula stored.</source>
        <translation>Sie hat mit einer Vorschau begonnen, die eine andere Version von Macula gespeichert hat.</translation>
    </message>
    <message>
        <source>The stored preview of this was damaged; it began anew.</source>
        <translation>Die gespeicherte Vorschau hiervon war beschädigt; sie hat neu begonnen.</translation>
    </message>
    <message>
        <source>Preview not sharp enough to be shown</source>
        <translation>Vorschau nicht scharf genug, um gezeigt zu werden</translation>
    </message>
    <message>
        <source>Preparing the preview, longer at the first start</source>
        <translation>Vorschau wird vorbereitet, beim ersten Start länger</translation>
    </message>
    <message>
        <source>At its first start Macula compiles its programs for the graphics device. Later starts find them.</source>
        <translation>Beim ersten Start übersetzt Macula seine Programme für das Grafikgerät. Spätere Starts finden sie vor.</translation>
    </message>
    <message>
        <source>It began with the preview of a neighbouring phase.</source>
        <translation>Sie begann mit der Vorschau einer benachbarten Phase.</translation>
    </message>
</context>
<context>
    <name>PaneClip</name>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
</context>
<context>
    <name>PaneCurve</name>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
</context>
<context>
    <name>PaneMeasurements</name>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>Plane alone: %1</source>
        <translation>Ebene allein: %1</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Measurement removed</source>
        <translation>Messung entfernt</translation>
    </message>
    <message>
        <source>Measurement moved</source>
        <translation>Messung verschoben</translation>
    </message>
    <message>
        <source>Lymph node</source>
        <translation>Lymphknoten</translation>
    </message>
</context>
<context>
    <name>PaneRequest</name>
    <message>
        <source>In colours: the size of pixels is not calibrated</source>
        <translation>In Farben: Die Pixelgröße ist nicht kalibriert</translation>
    </message>
    <message>
        <source>In colours: some slices are interpolated</source>
        <translation>In Farbe: einige Schichten sind interpoliert</translation>
    </message>
    <message>
        <source>In colours: %1</source>
        <translation>In Farben: %1</translation>
    </message>
    <message>
        <source>The size of its pixels is not calibrated</source>
        <translation>Die Größe seiner Pixel ist nicht kalibriert</translation>
    </message>
    <message>
        <source>Some of its slices are interpolated</source>
        <translation>Einige seiner Schichten sind interpoliert</translation>
    </message>
    <message>
        <source>In the plane of the study: %1</source>
        <translation>In der Ebene der Studie: %1</translation>
    </message>
    <message>
        <source>Not in a plane of the study</source>
        <translation>Nicht in einer Ebene der Studie</translation>
    </message>
    <message>
        <source>The dose is relative, and not in Gy</source>
        <translation>Die Dosis ist relativ und nicht in Gy</translation>
    </message>
    <message>
        <source>A difference of doses, and no dose</source>
        <translation>Ein Unterschied von Dosen und keine Dosis</translation>
    </message>
    <message>
        <source>Segments are of the open phase, and not shown here</source>
        <translation>Segmente gehören zur geöffneten Phase und sind hier nicht gezeigt</translation>
    </message>
    <message>
        <source>In colours: placed for the open phase</source>
        <translation>In Farben: für die geöffnete Phase platziert</translation>
    </message>
    <message>
        <source>Blue is lower, orange is higher, black has no value</source>
        <translation>Blau ist niedriger, orange höher, schwarz ist ohne Wert</translation>
    </message>
</context>
<context>
    <name>PaneTurn</name>
    <message>
        <source>Turn Planes</source>
        <translation>Ebenen drehen</translation>
    </message>
    <message>
        <source>Lines turned by %1</source>
        <translation>Linien um %1 gedreht</translation>
    </message>
</context>
<context>
    <name>PatientQuestion</name>
    <message>
        <source>ID</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>date of birth</source>
        <translation>Geburtsdatum</translation>
    </message>
    <message>
        <source>sex</source>
        <translation>Geschlecht</translation>
    </message>
    <message>
        <source>Another patient?</source>
        <translation>Anderer Patient?</translation>
    </message>
    <message>
        <source>The second volume is of another patient than the study. What differs: %1.</source>
        <translation>Das zweite Volumen ist von einem anderen Patienten als die Studie. Das weicht ab: %1.</translation>
    </message>
    <message>
        <source>Open it only if you know that both are of one patient, or mean to compare two patients. Pictures of it will say so.</source>
        <translation>Öffnen Sie es nur, wenn sicher ist, dass beide von einem Patienten sind, oder um zwei Patienten zu vergleichen. Bilder davon sagen es.</translation>
    </message>
    <message>
        <source>&amp;Open All the Same</source>
        <translation>&amp;Trotzdem öffnen</translation>
    </message>
</context>
<context>
    <name>PhaseIn3d</name>
    <message>
        <source>3D shows another phase than the one that is open. Open that phase first, or show the open one.</source>
        <translation>3D zeigt eine andere Phase als die geöffnete. Öffnen Sie zuerst diese Phase, oder zeigen Sie die geöffnete.</translation>
    </message>
</context>
<context>
    <name>Picture</name>
    <message>
        <source>Axial slices; 3D is not shown</source>
        <translation>Axiale Schichten; 3D wird nicht gezeigt</translation>
    </message>
    <message>
        <source>Coronal slices; 3D is not shown</source>
        <translation>Koronale Schichten; 3D wird nicht gezeigt</translation>
    </message>
    <message>
        <source>Sagittal slices; 3D is not shown</source>
        <translation>Sagittale Schichten; 3D wird nicht gezeigt</translation>
    </message>
</context>
<context>
    <name>PictureTexts</name>
    <message>
        <source>In colours: %1</source>
        <translation>In Farben: %1</translation>
    </message>
    <message>
        <source>Middle of the slab: %1</source>
        <translation>Mitte des Slabs: %1</translation>
    </message>
    <message>
        <source>%1, in %2</source>
        <translation>%1, in %2</translation>
    </message>
    <message>
        <source>Measurements are of the study alone</source>
        <translation>Messungen gelten nur für die Studie</translation>
    </message>
    <message>
        <source>Segments: middle of the slab</source>
        <translation>Segmente: Mitte des Slabs</translation>
    </message>
    <message>
        <source>No memory for this picture: make the window smaller</source>
        <translation>Kein Speicher für dieses Bild: machen Sie das Fenster kleiner</translation>
    </message>
    <message>
        <source>Segments: fractions of half or more</source>
        <translation>Segmente: Anteile ab der Hälfte</translation>
    </message>
    <message>
        <source>Segments: nearest voxel of another grid</source>
        <translation>Segmente: nächstes Voxel eines anderen Rasters</translation>
    </message>
    <message>
        <source>Low values are white, as in the images</source>
        <translation>Niedrige Werte sind weiß, wie in den Bildern</translation>
    </message>
    <message>
        <source>Low values are white, as is custom for PET</source>
        <translation>Niedrige Werte sind weiß, wie bei PET üblich</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Invertiert</translation>
    </message>
    <message>
        <source>Interpolated between dashed lines: no image was taken there</source>
        <translation>Zwischen gestrichelten Linien interpoliert: dort wurde kein Bild aufgenommen</translation>
    </message>
    <message>
        <source>Some of these slices are interpolated</source>
        <translation>Einige dieser Schichten sind interpoliert</translation>
    </message>
    <message>
        <source>Some slices of the slab are interpolated</source>
        <translation>Einige Schichten des Slabs sind interpoliert</translation>
    </message>
    <message>
        <source>Interpolated: no image was taken here</source>
        <translation>Interpoliert: hier wurde kein Bild aufgenommen</translation>
    </message>
    <message>
        <source>Isodoses: middle of the slab</source>
        <translation>Isodosen: Mitte des Slabs</translation>
    </message>
</context>
<context>
    <name>PlanarDisplays</name>
    <message>
        <source>All values</source>
        <translation>Alle Werte</translation>
    </message>
</context>
<context>
    <name>PlanarTexts</name>
    <message>
        <source>image %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>, frame %1 of %2</source>
        <translation>, Einzelbild %1 von %2</translation>
    </message>
    <message>
        <source>Table %1 of the file</source>
        <translation>Tabelle %1 der Datei</translation>
    </message>
    <message>
        <source>Table: %1</source>
        <translation>Tabelle: %1</translation>
    </message>
    <message>
        <source>turned by %1°</source>
        <translation>um %1° gedreht</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>gespiegelt</translation>
    </message>
    <message>
        <source>inverted</source>
        <translation>invertiert</translation>
    </message>
    <message>
        <source>%1 mm per pixel</source>
        <translation>%1 mm je Pixel</translation>
    </message>
    <message>
        <source>%1 × %2 mm per pixel</source>
        <translation>%1 × %2 mm je Pixel</translation>
    </message>
    <message>
        <source>%1, at the detector: the patient is smaller</source>
        <translation>%1, am Detektor: der Patient ist kleiner</translation>
    </message>
    <message>
        <source>%1, estimated by a magnification of %2</source>
        <translation>%1, geschätzt aus einer Vergrößerung von %2</translation>
    </message>
    <message>
        <source>%1, only in the regions of ultrasound that have lengths</source>
        <translation>%1, nur in den Ultraschallbereichen, die Längen haben</translation>
    </message>
    <message>
        <source>Table of the presentation state</source>
        <translation>Tabelle des Presentation States</translation>
    </message>
    <message>
        <source>%1 of the scanned film: the patient&apos;s size is not known</source>
        <translation>%1 des gescannten Films: Die Größe des Patienten ist nicht bekannt</translation>
    </message>
</context>
<context>
    <name>Preset</name>
    <message>
        <source>The preset %1 is made for values in %2; those of this volume are %3. What it shows here, and in which colours, means nothing.</source>
        <translation>Die Voreinstellung %1 ist für Werte in %2 gemacht; die dieses Volumens sind %3. Was sie hier zeigt und in welchen Farben, bedeutet nichts.</translation>
    </message>
    <message>
        <source>another unit</source>
        <translation>einer anderen Einheit</translation>
    </message>
    <message>
        <source>raw numbers of the scanner</source>
        <translation>rohe Zahlen des Geräts</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>The preset %1 is made for %2; this volume is %3. Its colours may mean something else here.</source>
        <translation>Die Voreinstellung %1 ist für %2 gemacht; dieses Volumen ist %3. Ihre Farben können hier etwas anderes bedeuten.</translation>
    </message>
</context>
<context>
    <name>QDialog</name>
    <message>
        <source>%1 in pixels, 1 to %2</source>
        <translation>%1 in Pixeln, 1 bis %2</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ohne</translation>
    </message>
</context>
<context>
    <name>QueueDialog</name>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message numerus="yes">
        <source>waits, after %n tries</source>
        <translation>
            <numerusform>wartet, nach %n Versuch</numerusform>
            <numerusform>wartet, nach %n Versuchen</numerusform>
        </translation>
    </message>
    <message>
        <source>is being sent</source>
        <translation>wird gesendet</translation>
    </message>
    <message>
        <source>refused by the archive</source>
        <translation>vom Archiv abgelehnt</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>The notes on these objects cannot be read. The objects lie in %1.</source>
        <translation>Die Notizen zu diesen Objekten können nicht gelesen werden. Die Objekte liegen in %1.</translation>
    </message>
</context>
<context>
    <name>QuitQuestion</name>
    <message>
        <source>Quit?</source>
        <translation>Beenden?</translation>
    </message>
    <message>
        <source>If you quit now, no file of it is left.</source>
        <translation>Wenn Sie jetzt beenden, bleibt keine Datei davon übrig.</translation>
    </message>
    <message>
        <source>&amp;Finish, Then Quit</source>
        <translation>&amp;Fertigstellen, dann beenden</translation>
    </message>
    <message>
        <source>&amp;Quit Now</source>
        <translation>&amp;Jetzt beenden</translation>
    </message>
    <message>
        <source>If you quit now, only what is stored by then has arrived; the queue keeps what it has.</source>
        <translation>Wenn Sie jetzt beenden, ist nur angekommen, was bis dahin gespeichert ist; die Warteschlange behält, was sie hat.</translation>
    </message>
</context>
<context>
    <name>ScaleBar</name>
    <message>
        <source>%1 at centre</source>
        <translation>%1 in der Mitte</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
</context>
<context>
    <name>SecondVolumeTexts</name>
    <message>
        <source>Prior: %1</source>
        <translation>Voraufnahme: %1</translation>
    </message>
    <message>
        <source>Later: %1</source>
        <translation>Später: %1</translation>
    </message>
    <message>
        <source>Second, same day: %1</source>
        <translation>Zweites, gleicher Tag: %1</translation>
    </message>
    <message>
        <source>Second: %1</source>
        <translation>Zweites: %1</translation>
    </message>
    <message>
        <source>ANOTHER PATIENT than the study</source>
        <translation>ANDERER PATIENT als die Studie</translation>
    </message>
    <message>
        <source>The images do not tell whether both are of one patient</source>
        <translation>Die Bilder sagen nicht, ob beide von einem Patienten sind</translation>
    </message>
    <message>
        <source>Current: %1</source>
        <translation>Aktuell: %1</translation>
    </message>
    <message>
        <source>Registration is doubtful: nearly as good %1 mm away; check landmarks</source>
        <translation>Registrierung unsicher: %1 mm daneben fast ebenso gut; Landmarken prüfen</translation>
    </message>
    <message>
        <source>Registration is doubtful (%1 mm): check landmarks</source>
        <translation>Registrierung unsicher (%1 mm): Landmarken prüfen</translation>
    </message>
    <message>
        <source>Registered, rigid; searches agree to %1 mm</source>
        <translation>Registriert, starr; Suchläufe stimmen auf %1 mm überein</translation>
    </message>
    <message>
        <source>Not registered: positions cannot be compared</source>
        <translation>Nicht registriert: Orte sind nicht vergleichbar</translation>
    </message>
    <message>
        <source>%1 to %2 %3, %4 % of the highest</source>
        <translation>%1 bis %2 %3, %4 % des höchsten</translation>
    </message>
    <message>
        <source>Same frame, not registered: the patient may have moved</source>
        <translation>Gleiches Koordinatensystem, nicht registriert: evtl. bewegt</translation>
    </message>
    <message>
        <source>Dose in the frame of reference of the images: nothing is registered</source>
        <translation>Dosis im Koordinatensystem der Bilder: Nichts ist registriert</translation>
    </message>
</context>
<context>
    <name>SegmentEdits</name>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Segment in colour</source>
        <translation>Segment farbig</translation>
    </message>
    <message>
        <source>Segments in 3D</source>
        <translation>Segmente in 3D</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Segmentations</source>
        <translation>Segmentierungen</translation>
    </message>
</context>
<context>
    <name>SegmentFilter</name>
    <message>
        <source>Largest part</source>
        <translation>Größter Teil</translation>
    </message>
    <message>
        <source>Small parts</source>
        <translation>Kleine Teile</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Between slices</source>
        <translation>Zwischen Schichten</translation>
    </message>
    <message>
        <source>Larger segment</source>
        <translation>Größeres Segment</translation>
    </message>
    <message>
        <source>Smaller segment</source>
        <translation>Kleineres Segment</translation>
    </message>
</context>
<context>
    <name>SegmentStroke</name>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
</context>
<context>
    <name>ShownImage</name>
    <message>
        <source>the presentation state is not of this image, which is shown as stored</source>
        <translation>der Presentation State gehört nicht zu diesem Bild; es ist wie gespeichert gezeigt</translation>
    </message>
    <message>
        <source>a shutter hides part of the image</source>
        <translation>eine Blende verdeckt einen Teil des Bildes</translation>
    </message>
    <message>
        <source>overlays are hidden</source>
        <translation>Overlays sind ausgeblendet</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>Column %1, row %2: %3</source>
        <translation>Spalte %1, Zeile %2: %3</translation>
    </message>
</context>
<context>
    <name>SliceKeys</name>
    <message>
        <source>Inverted</source>
        <translation>Invertiert</translation>
    </message>
</context>
<context>
    <name>SliceMenu</name>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>&amp;Keep This Window…</source>
        <translation>Diese Fensterung &amp;behalten…</translation>
    </message>
    <message>
        <source>Under a name, for all studies with values of this unit</source>
        <translation>Unter einem Namen, für alle Studien mit Werten in dieser Einheit</translation>
    </message>
    <message>
        <source>&amp;Remove a Window</source>
        <translation>Fensterung &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Label…	Enter</source>
        <translation>Be&amp;schriftung…	Eingabe</translation>
    </message>
    <message>
        <source>Words beside this measurement</source>
        <translation>Wörter neben dieser Messung</translation>
    </message>
    <message>
        <source>Keep This Window</source>
        <translation>Diese Fensterung behalten</translation>
    </message>
    <message>
        <source>Name of the window %1</source>
        <translation>Name der Fensterung %1</translation>
    </message>
    <message>
        <source>&amp;Fit the Pane	%1</source>
        <translation>&amp;Ins Bildfeld einpassen	%1</translation>
    </message>
    <message>
        <source>The whole slice is seen, in the middle of the pane</source>
        <translation>Die ganze Schicht ist zu sehen, in der Mitte des Bildfelds</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Hot iron</source>
        <translation>Glühendes Eisen</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>&amp;Type a Window…	%1</source>
        <translation>Fensterung ein&amp;geben…	%1</translation>
    </message>
    <message>
        <source>Width and level as numbers</source>
        <translation>Weite und Lage als Zahlen</translation>
    </message>
    <message>
        <source>C&amp;opy the Picture	Ctrl+C</source>
        <translation>Bild &amp;kopieren	Strg+C</translation>
    </message>
    <message>
        <source>This pane as it is on screen, with its measurements and names</source>
        <translation>Dieses Bildfeld, wie es auf dem Bildschirm ist, mit seinen Messungen und Namen</translation>
    </message>
    <message>
        <source>&amp;Save the Picture…</source>
        <translation>Bild &amp;speichern…</translation>
    </message>
    <message>
        <source>Window of the Slices</source>
        <translation>Fensterung der Schichten</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Weite</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>&amp;Lage</translation>
    </message>
    <message>
        <source>Save a &amp;Batch of Planes…</source>
        <translation>E&amp;benenreihe speichern …</translation>
    </message>
    <message>
        <source>Planes like this one, or about a line, as a DICOM series that keeps its place in the patient</source>
        <translation>Ebenen wie diese, oder um eine Linie, als DICOM-Serie, die ihre Lage im Patienten behält</translation>
    </message>
    <message>
        <source>Lymph &amp;Node</source>
        <translation>&amp;Lymphknoten</translation>
    </message>
    <message>
        <source>Its short axis counts in the follow-up, not its long one</source>
        <translation>In der Verlaufskontrolle zählt seine kurze Achse, nicht die lange</translation>
    </message>
</context>
<context>
    <name>SlicePainting</name>
    <message>
        <source>No study is open</source>
        <translation>Keine Studie ist offen</translation>
    </message>
</context>
<context>
    <name>SliceTool</name>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>All panes go to the point that is clicked or dragged to</source>
        <translation>Alle Bildfelder gehen zu dem Punkt, der angeklickt oder auf den gezogen wird</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Drag: wider to the right, brighter up</source>
        <translation>Ziehen: nach rechts breiter, nach oben heller</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Drag: closer up, farther down</source>
        <translation>Ziehen: nach oben näher, nach unten weiter weg</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Drag the picture sideways</source>
        <translation>Das Bild seitwärts ziehen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Measure from point to point, in mm</source>
        <translation>Von Punkt zu Punkt messen, in mm</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Measure between two legs, in degrees</source>
        <translation>Zwischen zwei Schenkeln messen, in Grad</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Measure area, in mm², and values within it</source>
        <translation>Fläche in mm² und Werte darin messen</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Messpunkt</translation>
    </message>
    <message>
        <source>Read the value of the voxel that is pointed at, in its unit</source>
        <translation>Den Wert des Voxels unter dem Zeiger ablesen, in seiner Einheit</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Set the points that a curved plane runs through</source>
        <translation>Punkte setzen, durch die eine gekrümmte Ebene verläuft</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>Paint, erase or grow the own segment that is selected</source>
        <translation>Das gewählte eigene Segment malen, radieren oder wachsen lassen</translation>
    </message>
    <message>
        <source>Lesion</source>
        <translation>Läsion</translation>
    </message>
    <message>
        <source>Measure both axes of a lesion, in mm: the long one, then half of the short</source>
        <translation>Beide Achsen einer Läsion in mm messen: die lange, dann die Hälfte der kurzen</translation>
    </message>
    <message>
        <source>Cobb Angle</source>
        <translation>Cobb-Winkel</translation>
    </message>
    <message>
        <source>Measure between two lines, in degrees</source>
        <translation>Zwischen zwei Linien messen, in Grad</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Draw around something by hand, or click its corners and double-click the last: its area, and values within it</source>
        <translation>Etwas von Hand umfahren, oder seine Ecken anklicken und die letzte doppelklicken: Fläche und Werte darin</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Draw along something by hand, or click its points and double-click the last: its length, in mm</source>
        <translation>An etwas von Hand entlangfahren, oder seine Punkte anklicken und den letzten doppelklicken: Länge in mm</translation>
    </message>
    <message>
        <source>Arrow</source>
        <translation>Pfeil</translation>
    </message>
    <message>
        <source>Point at something, drag away, and type words</source>
        <translation>Auf etwas zeigen, wegziehen und Worte tippen</translation>
    </message>
</context>
<context>
    <name>SliceWindowing</name>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Window of the second volume</source>
        <translation>Fensterung des zweiten Volumens</translation>
    </message>
</context>
<context>
    <name>Slices</name>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>%1, oblique</source>
        <translation>%1, schräg</translation>
    </message>
    <message>
        <source>%1 %2 %3 mm</source>
        <translation>%1 %2 %3 mm</translation>
    </message>
    <message>
        <source>%1, slice %2 of %3</source>
        <translation>%1, Schicht %2 von %3</translation>
    </message>
    <message>
        <source>%1, image %2</source>
        <translation>%1, Bild %2</translation>
    </message>
    <message>
        <source>MIP %1 mm</source>
        <translation>MIP %1 mm</translation>
    </message>
    <message>
        <source>MinIP %1 mm</source>
        <translation>MinIP %1 mm</translation>
    </message>
    <message>
        <source>Mean %1 mm</source>
        <translation>Mittelwert %1 mm</translation>
    </message>
    <message>
        <source>Outside, %1</source>
        <translation>Außerhalb, %1</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Füllwert</translation>
    </message>
    <message>
        <source>%1 at (%2, %3, %4), %5</source>
        <translation>%1 bei (%2, %3, %4), %5</translation>
    </message>
    <message>
        <source>%1, not calibrated</source>
        <translation>%1, nicht kalibriert</translation>
    </message>
    <message>
        <source>%1, ends in interpolated slices</source>
        <translation>%1, endet in interpolierten Schichten</translation>
    </message>
    <message>
        <source>%1, %2 % interpolated</source>
        <translation>%1, %2 % interpoliert</translation>
    </message>
    <message>
        <source>%1, interpolated,</source>
        <translation>%1, interpoliert,</translation>
    </message>
    <message>
        <source>%1, turned by %2</source>
        <translation>%1, um %2 gedreht</translation>
    </message>
    <message>
        <source>%1, lymph node</source>
        <translation>%1, Lymphknoten</translation>
    </message>
</context>
<context>
    <name>TimeCurveDialog</name>
    <message>
        <source>Mean in each phase</source>
        <translation>Mittelwert in jeder Phase</translation>
    </message>
    <message>
        <source>Ellipse %1</source>
        <translation>Ellipse %1</translation>
    </message>
    <message>
        <source>Outline %1</source>
        <translation>Umriss %1</translation>
    </message>
</context>
<context>
    <name>TimeLeft</name>
    <message>
        <source>%1 min left</source>
        <translation>noch %1 min</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>noch %1 s</translation>
    </message>
</context>
<context>
    <name>Visibility</name>
    <message>
        <source>its values are %1 to %2 %3</source>
        <translation>seine Werte sind %1 bis %2 %3</translation>
    </message>
    <message>
        <source>All of this volume is %1 in the window %2: %3.</source>
        <translation>Dieses Volumen ist in der Fensterung %2 ganz %1: %3.</translation>
    </message>
    <message>
        <source>black</source>
        <translation>schwarz</translation>
    </message>
    <message>
        <source>white</source>
        <translation>weiß</translation>
    </message>
    <message>
        <source>This volume has no values: all of it is padding.</source>
        <translation>Dieses Volumen hat keine Werte: es besteht nur aus Füllwerten.</translation>
    </message>
    <message>
        <source>Nothing of this volume can be seen with the preset %1: %2.</source>
        <translation>Mit der Voreinstellung %1 ist von diesem Volumen nichts zu sehen: %2.</translation>
    </message>
    <message>
        <source> Presets that show something of it: %1.</source>
        <translation> Voreinstellungen, die etwas davon zeigen: %1.</translation>
    </message>
</context>
<context>
    <name>VolumeActions</name>
    <message>
        <source>Not of images: it would act on the volume that they hide. Esc goes back to it.</source>
        <translation>Nicht für Bilder: Es würde auf das Volumen wirken, das sie verdecken. Esc führt dorthin zurück.</translation>
    </message>
</context>
<context>
    <name>WindowContainer</name>
    <message>
        <source>Sides of the patient at the left, right, top and bottom: %1, %2, %3, %4</source>
        <translation>Seiten des Patienten links, rechts, oben und unten: %1, %2, %3, %4</translation>
    </message>
    <message>
        <source>Left drag or arrows walk around the patient, the wheel goes closer; sizes are in mm</source>
        <translation>Links ziehen oder Pfeile gehen um den Patienten herum, das Rad geht näher; Größen sind in mm</translation>
    </message>
    <message>
        <source>The volume in 3D</source>
        <translation>Das Volumen in 3D</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>The file could not be written.</source>
        <translation>Die Datei konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Check free space and permissions.</source>
        <translation>Prüfen Sie freien Platz und Zugriffsrechte.</translation>
    </message>
    <message>
        <source>The file does not exist.</source>
        <translation>Die Datei gibt es nicht.</translation>
    </message>
    <message>
        <source>Check the path.</source>
        <translation>Prüfen Sie den Pfad.</translation>
    </message>
    <message>
        <source>The file is larger than {} bytes.</source>
        <translation>Die Datei ist größer als {} Bytes.</translation>
    </message>
    <message>
        <source>Check that it is the file you meant.</source>
        <translation>Prüfen Sie, ob es die gemeinte Datei ist.</translation>
    </message>
    <message>
        <source>The file could not be read.</source>
        <translation>Die Datei konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check its permissions.</source>
        <translation>Prüfen Sie die Zugriffsrechte.</translation>
    </message>
    <message>
        <source>There is not enough memory for this series: it needs {}{}.</source>
        <translation>Für diese Serie ist nicht genug Speicher da: sie braucht {}{}.</translation>
    </message>
    <message>
        <source>Close other programs, or choose a smaller series.</source>
        <translation>Schließen Sie andere Programme, oder wählen Sie eine kleinere Serie.</translation>
    </message>
    <message>
        <source>Correct the camera.</source>
        <translation>Berichtigen Sie die Kamera.</translation>
    </message>
    <message>
        <source>The file could not be written: {}.</source>
        <translation>Die Datei konnte nicht geschrieben werden: {}.</translation>
    </message>
    <message>
        <source>The system has no random numbers.</source>
        <translation>Das System hat keine Zufallszahlen.</translation>
    </message>
    <message>
        <source>Try again.</source>
        <translation>Versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The folder to write into does not exist.</source>
        <translation>Den Zielordner gibt es nicht.</translation>
    </message>
    <message>
        <source>Create it, or choose another place.</source>
        <translation>Legen Sie ihn an, oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>What stands there is no file.</source>
        <translation>Was dort steht, ist keine Datei.</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>Wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>There is not enough memory to {}.</source>
        <translation>Es ist nicht genug Speicher da, um {}.</translation>
    </message>
    <message>
        <source>Close other programs, or choose something smaller.</source>
        <translation>Schließen Sie andere Programme, oder wählen Sie etwas Kleineres.</translation>
    </message>
    <message>
        <source>The system has no memory or threads left to {}.</source>
        <translation>Das System hat keinen Speicher oder keine Threads mehr, um {}.</translation>
    </message>
    <message>
        <source>Close other programs.</source>
        <translation>Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>The system gave an error when the program was to {}.</source>
        <translation>Das System meldete einen Fehler, als das Programm versuchte, {}.</translation>
    </message>
    <message>
        <source>Check disk, connection and permissions, and try again.</source>
        <translation>Prüfen Sie Datenträger, Verbindung und Zugriffsrechte, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The program could not {}: a size in it is beyond all bounds.</source>
        <translation>Dem Programm gelang es nicht, {}: Eine Größe darin liegt jenseits aller Grenzen.</translation>
    </message>
    <message>
        <source>Copy it again from its source.</source>
        <translation>Kopieren Sie es noch einmal von seiner Quelle.</translation>
    </message>
    <message>
        <source>The program could not {}, for a reason that it did not foresee.</source>
        <translation>Dem Programm gelang es nicht, {}, aus einem Grund, den es nicht vorhersah.</translation>
    </message>
    <message>
        <source>Try again; if it fails again, report it, with the log of the program.</source>
        <translation>Versuchen Sie es noch einmal; wenn es wieder misslingt, melden Sie es, mit dem Protokoll des Programms.</translation>
    </message>
    <message>
        <source>The key that makes identifiers unreadable for others could not be kept.</source>
        <translation>Der Schlüssel, der Kennungen für andere unlesbar macht, konnte nicht aufbewahrt werden.</translation>
    </message>
    <message>
        <source>Check free space and permissions of that folder.</source>
        <translation>Prüfen Sie freien Platz und Rechte dieses Ordners.</translation>
    </message>
    <message>
        <source>The file with the key that makes identifiers unreadable for others cannot be read, or holds none.</source>
        <translation>Die Datei mit dem Schlüssel, der Kennungen für andere unlesbar macht, kann nicht gelesen werden oder enthält keinen.</translation>
    </message>
    <message>
        <source>Bring it back from a backup, or remove it: then a new one is made.</source>
        <translation>Holen Sie sie aus einer Sicherung zurück, oder löschen Sie sie: dann wird ein neuer gemacht.</translation>
    </message>
    <message>
        <source>Choose another segmentation.</source>
        <translation>Wählen Sie eine andere Segmentierung.</translation>
    </message>
    <message>
        <source>A part of Macula could not be loaded.</source>
        <translation>Ein Teil von Macula konnte nicht geladen werden.</translation>
    </message>
    <message>
        <source>Install Macula again, with the packages that it depends on.</source>
        <translation>Installieren Sie Macula noch einmal, mit den Paketen, die es braucht.</translation>
    </message>
    <message>
        <source>The 3D picture has values of 16 bits, with an error of at most {:.3g}{}.</source>
        <translation>Das 3D-Bild hat Werte von 16 Bit, mit einem Fehler von höchstens {:.3g}{}.</translation>
    </message>
    <message>
        <source>The 3D picture shows values below {:.4g}{} or above {:.4g}{} as these.</source>
        <translation>Das 3D-Bild zeigt Werte unter {:.4g}{} oder über {:.4g}{} wie diese.</translation>
    </message>
    <message>
        <source>Choose another series.</source>
        <translation>Wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>The image has no usable size.</source>
        <translation>Das Bild hat keine brauchbare Größe.</translation>
    </message>
    <message>
        <source>This series is no volume.</source>
        <translation>Diese Serie ist kein Volumen.</translation>
    </message>
    <message>
        <source>The images of this series have no usable size.</source>
        <translation>Die Bilder dieser Serie haben keine brauchbare Größe.</translation>
    </message>
    <message>
        <source>The images of this series differ in size or in kind.</source>
        <translation>Die Bilder dieser Serie unterscheiden sich in Größe oder Art.</translation>
    </message>
    <message>
        <source>The values of these cannot be what the images say.</source>
        <translation>Ihre Werte können nicht die sein, die die Bilder angeben.</translation>
    </message>
    <message>
        <source>Export the series again.</source>
        <translation>Exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>Decoding {} slices</source>
        <translation>{} Schichten werden dekodiert</translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation>Das Laden wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is not enough memory to decode the slices.</source>
        <translation>Es ist nicht genug Speicher da, um die Schichten zu dekodieren.</translation>
    </message>
    <message>
        <source>The compressed image in this file is damaged.</source>
        <translation>Das komprimierte Bild in dieser Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>Copy the file again from its source.</source>
        <translation>Kopieren Sie die Datei noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>The JPEG 2000 image in this file cannot be decoded.</source>
        <translation>Das JPEG-2000-Bild in dieser Datei kann nicht dekodiert werden.</translation>
    </message>
    <message>
        <source>The pixel data of this file are damaged.</source>
        <translation>Die Pixeldaten dieser Datei sind beschädigt.</translation>
    </message>
    <message>
        <source>The file ends before its pixel data do.</source>
        <translation>Die Datei endet vor ihren Pixeldaten.</translation>
    </message>
    <message>
        <source>This version cannot decode this image: {}.</source>
        <translation>Diese Version kann dieses Bild nicht dekodieren: {}.</translation>
    </message>
    <message>
        <source>Export the series uncompressed or in JPEG 2000.</source>
        <translation>Exportieren Sie die Serie unkomprimiert oder in JPEG 2000.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>Die Datei kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check that the file or disc is still there.</source>
        <translation>Prüfen Sie, ob Datei oder Datenträger noch da ist.</translation>
    </message>
    <message>
        <source>The file has changed since the folder was read.</source>
        <translation>Die Datei hat sich geändert, seit der Ordner gelesen wurde.</translation>
    </message>
    <message>
        <source>Open the folder again.</source>
        <translation>Öffnen Sie den Ordner noch einmal.</translation>
    </message>
    <message>
        <source>The file has no pixel data that fit its header.</source>
        <translation>Die Datei hat keine Pixeldaten, die zu ihrem Kopf passen.</translation>
    </message>
    <message>
        <source>It cannot be told where the images in this file begin.</source>
        <translation>Es ist nicht zu erkennen, wo die Bilder in dieser Datei beginnen.</translation>
    </message>
    <message>
        <source>There is not enough memory to decode a slice.</source>
        <translation>Es ist nicht genug Speicher da, um eine Schicht zu dekodieren.</translation>
    </message>
    <message>
        <source>The pixel data of this file cannot be decoded.</source>
        <translation>Die Pixeldaten dieser Datei können nicht dekodiert werden.</translation>
    </message>
    <message>
        <source>The images of this file have no usable size.</source>
        <translation>Die Bilder dieser Datei haben keine brauchbare Größe.</translation>
    </message>
    <message>
        <source>Copy the file again from its source, or choose another presentation state.</source>
        <translation>Kopieren Sie die Datei noch einmal von ihrer Quelle, oder wählen Sie einen anderen Presentation State.</translation>
    </message>
    <message>
        <source>The presentation state does not say in which colours.</source>
        <translation>Der Presentation State sagt nicht, in welchen Farben.</translation>
    </message>
    <message>
        <source>The presentation state does not say which images it is of.</source>
        <translation>Der Presentation State sagt nicht, von welchen Bildern er ist.</translation>
    </message>
    <message>
        <source>The presentation state is of something that is no volume.</source>
        <translation>Der Presentation State ist von etwas, das kein Volumen ist.</translation>
    </message>
    <message>
        <source>The presentation state does not say which series it is of.</source>
        <translation>Der Presentation State sagt nicht, von welcher Serie er ist.</translation>
    </message>
    <message>
        <source>The presentation state does not say where it is looked from.</source>
        <translation>Der Presentation State sagt nicht, von wo aus er gesehen wird.</translation>
    </message>
    <message>
        <source>The presentation state is drawn by a method that Macula does not know.</source>
        <translation>Der Presentation State wird mit einem Verfahren gezeichnet, das Macula nicht kennt.</translation>
    </message>
    <message>
        <source>The colours of the presentation state are damaged.</source>
        <translation>Die Farben des Presentation State sind beschädigt.</translation>
    </message>
    <message>
        <source>The presentation state has a table of values (VOI LUT) before its colours, which Macula does not know.</source>
        <translation>Der Presentation State hat vor seinen Farben eine Wertetabelle (VOI LUT), die Macula nicht kennt.</translation>
    </message>
    <message>
        <source>The presentation state does not say which values its colours are of.</source>
        <translation>Der Presentation State sagt nicht, zu welchen Werten seine Farben gehören.</translation>
    </message>
    <message>
        <source>A clip of the presentation state is missing in the file.</source>
        <translation>Ein Beschnitt des Presentation State fehlt in der Datei.</translation>
    </message>
    <message>
        <source>A clip of the presentation state is damaged.</source>
        <translation>Ein Beschnitt des Presentation State ist beschädigt.</translation>
    </message>
    <message>
        <source>The file is not a DICOM presentation state.</source>
        <translation>Die Datei ist kein Presentation State in DICOM.</translation>
    </message>
    <message>
        <source>The presentation state cannot be read.</source>
        <translation>Der Presentation State kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file is no presentation state of one rendered volume.</source>
        <translation>Die Datei ist kein Presentation State eines gerenderten Volumens.</translation>
    </message>
    <message>
        <source>There is not enough memory for the presentation state.</source>
        <translation>Für den Presentation State ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>The label of the presentation state is not usable.</source>
        <translation>Die Bezeichnung des Presentation State ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Take 1 to 16 capital letters, digits, blanks and underscores.</source>
        <translation>Nehmen Sie 1 bis 16 Großbuchstaben, Ziffern, Leerzeichen und Unterstriche.</translation>
    </message>
    <message>
        <source>The description is too long, or has characters that it may not have.</source>
        <translation>Die Beschreibung ist zu lang oder hat Zeichen, die sie nicht haben darf.</translation>
    </message>
    <message>
        <source>Take at most 64 letters, digits and signs, without a backslash.</source>
        <translation>Nehmen Sie höchstens 64 Buchstaben, Ziffern und Zeichen, ohne umgekehrten Schrägstrich.</translation>
    </message>
    <message>
        <source>The view is too large for a presentation state.</source>
        <translation>Die Ansicht ist für einen Presentation State zu groß.</translation>
    </message>
    <message>
        <source>Save it as a view, or remove measurements and large presets from it.</source>
        <translation>Speichern Sie sie als Ansicht, oder entfernen Sie Messungen und große Voreinstellungen daraus.</translation>
    </message>
    <message>
        <source>The colours of the presentation state are not usable.</source>
        <translation>Die Farben des Presentation State sind nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose another preset, or a window above 0.</source>
        <translation>Wählen Sie eine andere Voreinstellung oder eine Fensterung über 0.</translation>
    </message>
    <message>
        <source>The camera of the presentation state is not usable.</source>
        <translation>Die Kamera des Presentation State ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose another view.</source>
        <translation>Wählen Sie eine andere Ansicht.</translation>
    </message>
    <message>
        <source>The clip of the presentation state is not usable.</source>
        <translation>Der Beschnitt des Presentation State ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose another clip.</source>
        <translation>Wählen Sie einen anderen Beschnitt.</translation>
    </message>
    <message>
        <source>The opacities of the presentation state are not usable.</source>
        <translation>Die Deckkräfte des Presentation State sind nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose another preset.</source>
        <translation>Wählen Sie eine andere Voreinstellung.</translation>
    </message>
    <message>
        <source>The shading of the presentation state is not usable.</source>
        <translation>Die Schattierung des Presentation State ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>A presentation state refers to DICOM images with a frame of reference, and this volume has none.</source>
        <translation>Ein Presentation State bezieht sich auf DICOM-Bilder mit einem Koordinatensystem, und dieses Volumen hat keines.</translation>
    </message>
    <message>
        <source>Save it as a view.</source>
        <translation>Speichern Sie sie als Ansicht.</translation>
    </message>
    <message>
        <source>The files of this study do not say which patient and which study it is.</source>
        <translation>Die Dateien dieser Studie sagen nicht, welcher Patient und welche Studie es ist.</translation>
    </message>
    <message>
        <source>Write the presentation state without patient and study.</source>
        <translation>Speichern Sie den Presentation State ohne Patient und Studie.</translation>
    </message>
    <message>
        <source>The DICOM file could not be written.</source>
        <translation>Die DICOM-Datei konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Check free space and memory.</source>
        <translation>Prüfen Sie freien Platz und Speicher.</translation>
    </message>
    <message>
        <source>The path is longer than this system can open.</source>
        <translation>Der Pfad ist länger, als dieses System öffnen kann.</translation>
    </message>
    <message>
        <source>Move the folder nearer to the root of the disk, or give the folders shorter names.</source>
        <translation>Verschieben Sie den Ordner näher an die Wurzel des Laufwerks, oder geben Sie den Ordnern kürzere Namen.</translation>
    </message>
    <message>
        <source>The folder does not exist.</source>
        <translation>Den Ordner gibt es nicht.</translation>
    </message>
    <message>
        <source>The folder cannot be read.</source>
        <translation>Der Ordner kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check that it is a folder, and its permissions.</source>
        <translation>Prüfen Sie, ob es ein Ordner ist, und seine Zugriffsrechte.</translation>
    </message>
    <message>
        <source>Reading was cancelled.</source>
        <translation>Das Lesen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The file is not the directory of a DICOM disc.</source>
        <translation>Die Datei ist nicht das Verzeichnis eines DICOM-Datenträgers.</translation>
    </message>
    <message>
        <source>Open the folder instead.</source>
        <translation>Öffnen Sie stattdessen den Ordner.</translation>
    </message>
    <message>
        <source>The dictionary of the DICOM toolkit (dicom.dic) is not there, so that DICOM files cannot be read.</source>
        <translation>Das Wörterbuch des DICOM-Toolkits (dicom.dic) fehlt, sodass DICOM-Dateien nicht gelesen werden können.</translation>
    </message>
    <message>
        <source>Install DCMTK&apos;s data files again, or set DCMDICTPATH to the path of dicom.dic.</source>
        <translation>Installieren Sie die Datendateien von DCMTK noch einmal, oder setzen Sie DCMDICTPATH auf den Pfad von dicom.dic.</translation>
    </message>
    <message>
        <source>Looking for files</source>
        <translation>Dateien werden gesucht</translation>
    </message>
    <message>
        <source>The frames of the segmentation lie too far apart.</source>
        <translation>Die Einzelbilder der Segmentierung liegen zu weit auseinander.</translation>
    </message>
    <message>
        <source>Reading a segmentation of {} frames</source>
        <translation>Eine Segmentierung mit {} Einzelbildern wird gelesen</translation>
    </message>
    <message>
        <source>The segmentation ends before its last frame does.</source>
        <translation>Die Segmentierung endet vor ihrem letzten Einzelbild.</translation>
    </message>
    <message>
        <source>The segmentation changed while it was read.</source>
        <translation>Die Segmentierung hat sich beim Lesen geändert.</translation>
    </message>
    <message>
        <source>Open the study again.</source>
        <translation>Öffnen Sie die Studie noch einmal.</translation>
    </message>
    <message>
        <source>The frames of the segmentation do not lie on one grid.</source>
        <translation>Die Einzelbilder der Segmentierung liegen nicht auf einem Gitter.</translation>
    </message>
    <message>
        <source>Putting segments on the voxels of the volume</source>
        <translation>Segmente werden auf die Voxel des Volumens gelegt</translation>
    </message>
    <message>
        <source>The series of the segmentation is no volume.</source>
        <translation>Die Serie der Segmentierung ist kein Volumen.</translation>
    </message>
    <message>
        <source>The segmentation cannot be read.</source>
        <translation>Die Segmentierung kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file is no segmentation that this version knows.</source>
        <translation>Die Datei ist keine Segmentierung, die diese Version kennt.</translation>
    </message>
    <message>
        <source>The frames of the segmentation are of no kind that this version knows.</source>
        <translation>Die Einzelbilder der Segmentierung sind von keiner Art, die diese Version kennt.</translation>
    </message>
    <message>
        <source>The segmentation does not say what its values mean.</source>
        <translation>Die Segmentierung sagt nicht, was ihre Werte bedeuten.</translation>
    </message>
    <message>
        <source>The segmentation does not say where all of its frames lie.</source>
        <translation>Die Segmentierung sagt nicht, wo alle ihre Einzelbilder liegen.</translation>
    </message>
    <message>
        <source>The segmentation does not say where its frames lie.</source>
        <translation>Die Segmentierung sagt nicht, wo ihre Einzelbilder liegen.</translation>
    </message>
    <message>
        <source>The segmentation does not say what its frames show.</source>
        <translation>Die Segmentierung sagt nicht, was ihre Einzelbilder zeigen.</translation>
    </message>
    <message>
        <source>The frames of the segmentation lie too far apart for a grid of their own.</source>
        <translation>Die Einzelbilder der Segmentierung liegen für ein eigenes Gitter zu weit auseinander.</translation>
    </message>
    <message>
        <source>Open it with the series it was drawn on.</source>
        <translation>Öffnen Sie sie mit der Serie, auf der sie gezeichnet wurde.</translation>
    </message>
    <message>
        <source>The segmentation has more segments than a label map can hold.</source>
        <translation>Die Segmentierung hat mehr Segmente, als eine Label-Map fassen kann.</translation>
    </message>
    <message>
        <source>Frame {} of the segmentation does not lie on the voxels of the series.</source>
        <translation>Einzelbild {} der Segmentierung liegt nicht auf den Voxeln der Serie.</translation>
    </message>
    <message>
        <source>Open the segmentation with the series it was drawn on.</source>
        <translation>Öffnen Sie die Segmentierung mit der Serie, auf der sie gezeichnet wurde.</translation>
    </message>
    <message>
        <source>The segmentation has no frames.</source>
        <translation>Die Segmentierung hat keine Einzelbilder.</translation>
    </message>
    <message>
        <source>Comparing {} files</source>
        <translation>{} Dateien werden verglichen</translation>
    </message>
    <message>
        <source>Images at one position were told apart by the order of their numbers.</source>
        <translation>Bilder an einer Position wurden nach der Reihenfolge ihrer Nummern unterschieden.</translation>
    </message>
    <message>
        <source>The study that it belongs to cannot be read any more.</source>
        <translation>Die Studie, zu der es gehört, kann nicht mehr gelesen werden.</translation>
    </message>
    <message>
        <source>Open the study again, or write it without the patient.</source>
        <translation>Öffnen Sie die Studie noch einmal, oder speichern Sie es ohne den Patienten.</translation>
    </message>
    <message>
        <source>The DICOM file could not be made.</source>
        <translation>Die DICOM-Datei konnte nicht erstellt werden.</translation>
    </message>
    <message>
        <source>Check memory.</source>
        <translation>Prüfen Sie den Speicher.</translation>
    </message>
    <message>
        <source>Choose another volume.</source>
        <translation>Wählen Sie ein anderes Volumen.</translation>
    </message>
    <message>
        <source>A DICOM file could not be written.</source>
        <translation>Eine DICOM-Datei konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The folder to write into cannot be created.</source>
        <translation>Der Zielordner kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>Check the permissions, or choose another place.</source>
        <translation>Prüfen Sie die Zugriffsrechte, oder wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>Writing {} slices</source>
        <translation>{} Schichten werden geschrieben</translation>
    </message>
    <message>
        <source>Writing was cancelled.</source>
        <translation>Das Schreiben wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The folder to write into is not empty, or cannot be replaced.</source>
        <translation>Der Zielordner ist nicht leer oder kann nicht ersetzt werden.</translation>
    </message>
    <message>
        <source>Choose a folder that is empty or does not exist.</source>
        <translation>Wählen Sie einen Ordner, der leer ist oder den es noch nicht gibt.</translation>
    </message>
    <message>
        <source>The series could not be written.</source>
        <translation>Die Serie konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Check free space, memory and permissions.</source>
        <translation>Prüfen Sie freien Platz, Speicher und Zugriffsrechte.</translation>
    </message>
    <message>
        <source>This is no MetaImage file.</source>
        <translation>Das ist keine MetaImage-Datei.</translation>
    </message>
    <message>
        <source>The image has several values in each voxel; a volume needs one.</source>
        <translation>Das Bild hat mehrere Werte in jedem Voxel; ein Volumen braucht einen.</translation>
    </message>
    <message>
        <source>The values of the image are neither whole numbers of 8 to 64 bits nor floating-point ones.</source>
        <translation>Die Werte des Bildes sind weder ganze Zahlen mit 8 bis 64 Bit noch Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>The values have 8 bytes each, as the size of the file tells, and not 4 as their type says.</source>
        <translation>Die Werte haben je 8 Bytes, wie die Größe der Datei sagt, und nicht 4, wie ihr Typ sagt.</translation>
    </message>
    <message>
        <source>The file does not give the distance of the voxels: 1 mm was assumed.</source>
        <translation>Die Datei nennt den Abstand der Voxel nicht: 1 mm wurde angenommen.</translation>
    </message>
    <message>
        <source>The values are written as text, which Macula does not read.</source>
        <translation>Die Werte sind als Text geschrieben, den Macula nicht liest.</translation>
    </message>
    <message>
        <source>Write the file with BinaryData = True.</source>
        <translation>Schreiben Sie die Datei mit BinaryData = True.</translation>
    </message>
    <message>
        <source>The values lie in several files.</source>
        <translation>Die Werte liegen in mehreren Dateien.</translation>
    </message>
    <message>
        <source>Write the volume to one file.</source>
        <translation>Schreiben Sie das Volumen in eine Datei.</translation>
    </message>
    <message>
        <source>Convert it with the program it comes from.</source>
        <translation>Wandeln Sie sie mit dem Programm um, aus dem sie kommt.</translation>
    </message>
    <message>
        <source>The file is cut off or damaged.</source>
        <translation>Die Datei ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>Get the file again from where it came.</source>
        <translation>Holen Sie die Datei noch einmal, woher sie kam.</translation>
    </message>
    <message>
        <source>A NIfTI file holds no volume of {} x {} x {} voxels.</source>
        <translation>Eine NIfTI-Datei fasst kein Volumen aus {} x {} x {} Voxeln.</translation>
    </message>
    <message>
        <source>Write a .nrrd or .mha file.</source>
        <translation>Schreiben Sie eine .nrrd- oder .mha-Datei.</translation>
    </message>
    <message>
        <source>Check the path and its permissions.</source>
        <translation>Prüfen Sie den Pfad und seine Zugriffsrechte.</translation>
    </message>
    <message>
        <source>This is no NIfTI file.</source>
        <translation>Das ist keine NIfTI-Datei.</translation>
    </message>
    <message>
        <source>The image is in colour; a volume needs one value in each voxel.</source>
        <translation>Das Bild ist farbig; ein Volumen braucht einen Wert in jedem Voxel.</translation>
    </message>
    <message>
        <source>The values of the image have NIfTI&apos;s data type {}; Macula reads whole numbers of 8 to 64 bits and floating-point ones.</source>
        <translation>Die Werte des Bildes haben den NIfTI-Datentyp {}; Macula liest ganze Zahlen mit 8 bis 64 Bit und Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>The header of the NIfTI file is damaged.</source>
        <translation>Der Kopf der NIfTI-Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The file gives two positions in the patient that differ by up to {:.1f} mm (sform and qform): the sform was taken.</source>
        <translation>Die Datei gibt zwei Lagen im Patienten an, die um bis zu {:.1f} mm abweichen (sform und qform): die sform wurde genommen.</translation>
    </message>
    <message>
        <source>The file does not say how the image lies in the patient: its axes were taken to lead to the right, to the front and up. Left and right may be exchanged.</source>
        <translation>Die Datei sagt nicht, wie das Bild im Patienten liegt: es wurde angenommen, dass seine Achsen nach rechts, vorn und oben führen. Links und rechts können vertauscht sein.</translation>
    </message>
    <message>
        <source>The file with the values (.img) is missing.</source>
        <translation>Die Datei mit den Werten (.img) fehlt.</translation>
    </message>
    <message>
        <source>Put it beside the header.</source>
        <translation>Legen Sie sie neben den Kopf.</translation>
    </message>
    <message>
        <source>This is an ANALYZE file, which does not tell left from right.</source>
        <translation>Das ist eine ANALYZE-Datei, die links und rechts nicht unterscheidet.</translation>
    </message>
    <message>
        <source>Write it as NIfTI.</source>
        <translation>Schreiben Sie sie als NIfTI.</translation>
    </message>
    <message>
        <source>The position of the image in the patient is not usable: its axes do not span a volume.</source>
        <translation>Die Lage des Bildes im Patienten ist nicht brauchbar: seine Achsen spannen kein Volumen auf.</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Wird geschrieben</translation>
    </message>
    <message>
        <source>Stopped; nothing was written.</source>
        <translation>Angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>This is no NRRD file.</source>
        <translation>Das ist keine NRRD-Datei.</translation>
    </message>
    <message>
        <source>The position of the image is not given in millimetres.</source>
        <translation>Die Lage des Bildes ist nicht in Millimetern angegeben.</translation>
    </message>
    <message>
        <source>An axis of the image does not lie in space.</source>
        <translation>Eine Achse des Bildes liegt nicht im Raum.</translation>
    </message>
    <message>
        <source>Write one volume to a file of its own.</source>
        <translation>Schreiben Sie ein Volumen in eine eigene Datei.</translation>
    </message>
    <message>
        <source>The values are encoded in a way that Macula does not read.</source>
        <translation>Die Werte sind auf eine Weise kodiert, die Macula nicht liest.</translation>
    </message>
    <message>
        <source>Write the file with the encoding raw or gzip.</source>
        <translation>Schreiben Sie die Datei mit der Kodierung raw oder gzip.</translation>
    </message>
    <message>
        <source>Text stands before the values, which Macula does not read.</source>
        <translation>Vor den Werten steht Text, den Macula nicht liest.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Angehalten.</translation>
    </message>
    <message>
        <source>Preparing the values</source>
        <translation>Die Werte werden vorbereitet</translation>
    </message>
    <message>
        <source>Whole numbers beyond 2^53 were rounded.</source>
        <translation>Ganze Zahlen jenseits von 2^53 wurden gerundet.</translation>
    </message>
    <message>
        <source>Values were rounded to 24 significant bits.</source>
        <translation>Werte wurden auf 24 signifikante Bits gerundet.</translation>
    </message>
    <message>
        <source>{} voxels hold no finite number: they are treated as outside of the scan.</source>
        <translation>{} Voxel enthalten keine endliche Zahl: sie gelten als außerhalb der Aufnahme.</translation>
    </message>
    <message>
        <source>The size of a voxel is not calibrated: lengths, areas and volumes are estimates.</source>
        <translation>Die Größe eines Voxels ist nicht kalibriert: Längen, Flächen und Volumina sind Schätzungen.</translation>
    </message>
    <message>
        <source>The file holds {} volumes, one for each point in time; this is number {}.</source>
        <translation>Die Datei enthält {} Volumen, eines je Zeitpunkt; dies ist die Nummer {}.</translation>
    </message>
    <message>
        <source>The image of {} x {} x {} voxels is no volume.</source>
        <translation>Das Bild aus {} x {} x {} Voxeln ist kein Volumen.</translation>
    </message>
    <message>
        <source>Choose a file with a volume.</source>
        <translation>Wählen Sie eine Datei mit einem Volumen.</translation>
    </message>
    <message>
        <source>A volume of {} x {} x {} voxels cannot be shown.</source>
        <translation>Ein Volumen aus {} x {} x {} Voxeln kann nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>Choose a smaller one.</source>
        <translation>Wählen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>The file is cut off: its header tells of {} x {} x {} voxels, and it is too short for them.</source>
        <translation>Die Datei ist abgeschnitten: ihr Kopf nennt {} x {} x {} Voxel, und dafür ist sie zu kurz.</translation>
    </message>
    <message>
        <source>The map from stored values to units is not usable.</source>
        <translation>Die Abbildung gespeicherter Werte auf Einheiten ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Export the file again.</source>
        <translation>Exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Wird gelesen</translation>
    </message>
    <message>
        <source>The header of the file is damaged.</source>
        <translation>Der Kopf der Datei ist beschädigt.</translation>
    </message>
    <message>
        <source>The image has two axes; it is no volume.</source>
        <translation>Das Bild hat zwei Achsen; es ist kein Volumen.</translation>
    </message>
    <message>
        <source>The image has {} axes; Macula reads volumes with three.</source>
        <translation>Das Bild hat {} Achsen; Macula liest Volumen mit drei.</translation>
    </message>
    <message>
        <source>The values lie in another folder or in several files.</source>
        <translation>Die Werte liegen in einem anderen Ordner oder in mehreren Dateien.</translation>
    </message>
    <message>
        <source>Write the volume to one file, or put the file with the values beside the header.</source>
        <translation>Schreiben Sie das Volumen in eine Datei, oder legen Sie die Datei mit den Werten neben den Kopf.</translation>
    </message>
    <message>
        <source>The file with the values is missing.</source>
        <translation>Die Datei mit den Werten fehlt.</translation>
    </message>
    <message>
        <source>The ending of the name is that of no volume file.</source>
        <translation>Die Endung des Namens ist die keiner Volumendatei.</translation>
    </message>
    <message>
        <source>Volumes are not written to files with the ending {}.</source>
        <translation>Volumen werden nicht in Dateien mit der Endung {} geschrieben.</translation>
    </message>
    <message>
        <source>The file could not be put in place: {}.</source>
        <translation>Die Datei konnte nicht an ihren Ort gelegt werden: {}.</translation>
    </message>
    <message>
        <source>There is not enough free space.</source>
        <translation>Es ist nicht genug Platz frei.</translation>
    </message>
    <message>
        <source>The file needs {} MB.</source>
        <translation>Die Datei braucht {} MB.</translation>
    </message>
    <message>
        <source>it did not become whole</source>
        <translation>sie wurde nicht vollständig</translation>
    </message>
    <message>
        <source>something unforeseen happened</source>
        <translation>etwas Unvorhergesehenes ist geschehen</translation>
    </message>
    <message>
        <source>The mask does not fit the pictures.</source>
        <translation>Die Maske passt nicht zu den Bildern.</translation>
    </message>
    <message>
        <source>Give one number for each pixel.</source>
        <translation>Geben Sie eine Zahl für jedes Pixel an.</translation>
    </message>
    <message>
        <source>The number of pixels in a degree is not usable.</source>
        <translation>Die Zahl der Pixel je Grad ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give 1 to 1000.</source>
        <translation>Geben Sie 1 bis 1000 an.</translation>
    </message>
    <message>
        <source>There is no such fovea in a picture.</source>
        <translation>Eine solche Fovea gibt es in einem Bild nicht.</translation>
    </message>
    <message>
        <source>Give a picture of 0.1 to 170 degrees, a gaze inside it, and a field above 0 and at most 180 degrees.</source>
        <translation>Geben Sie ein Bild von 0.1 bis 170 Grad an, einen Blick darin und ein Feld über 0 und von höchstens 180 Grad.</translation>
    </message>
    <message>
        <source>Give one number for each pixel of the pictures.</source>
        <translation>Geben Sie eine Zahl für jedes Pixel der Bilder an.</translation>
    </message>
    <message>
        <source>Give a number for each pixel of the mask.</source>
        <translation>Geben Sie eine Zahl für jedes Pixel der Maske an.</translation>
    </message>
    <message>
        <source>Pictures of {} x {} pixels are too small for MS-SSIM.</source>
        <translation>Bilder von {} x {} Pixeln sind zu klein für MS-SSIM.</translation>
    </message>
    <message>
        <source>Compare pictures of at least {} pixels on each side.</source>
        <translation>Vergleichen Sie Bilder mit mindestens {} Pixeln je Seite.</translation>
    </message>
    <message>
        <source>The picture file is damaged or incomplete.</source>
        <translation>Die Bilddatei ist beschädigt oder unvollständig.</translation>
    </message>
    <message>
        <source>Export or download it again.</source>
        <translation>Exportieren oder laden Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>The picture could not be written.</source>
        <translation>Das Bild konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Check free space and permissions of the folder.</source>
        <translation>Prüfen Sie freien Platz und Zugriffsrechte des Ordners.</translation>
    </message>
    <message>
        <source>The picture file does not exist.</source>
        <translation>Die Bilddatei gibt es nicht.</translation>
    </message>
    <message>
        <source>The picture file could not be opened.</source>
        <translation>Die Bilddatei konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>The file is no Radiance HDR, OpenEXR or PNG picture.</source>
        <translation>Die Datei ist kein Bild in Radiance HDR, OpenEXR oder PNG.</translation>
    </message>
    <message>
        <source>Give a file of one of these formats; renaming does not convert it.</source>
        <translation>Wählen Sie eine Datei in einem dieser Formate; Umbenennen wandelt sie nicht um.</translation>
    </message>
    <message>
        <source>There is not enough memory for the picture.</source>
        <translation>Für das Bild ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Close other programs, or use a smaller picture.</source>
        <translation>Schließen Sie andere Programme, oder nehmen Sie ein kleineres Bild.</translation>
    </message>
    <message>
        <source>Give a picture of another format.</source>
        <translation>Wählen Sie ein Bild in einem anderen Format.</translation>
    </message>
    <message>
        <source>The file is no flat picture.</source>
        <translation>Die Datei ist kein flaches Bild.</translation>
    </message>
    <message>
        <source>Give a picture with one layer of pixels.</source>
        <translation>Wählen Sie ein Bild mit einer Lage von Pixeln.</translation>
    </message>
    <message>
        <source>The picture is too large: {} by {} pixels, {} channels.</source>
        <translation>Das Bild ist zu groß: {} mal {} Pixel, {} Kanäle.</translation>
    </message>
    <message>
        <source>Scale it to at most {} pixels on each side.</source>
        <translation>Verkleinern Sie es auf höchstens {} Pixel je Seite.</translation>
    </message>
    <message>
        <source>The picture has too many pixels and channels.</source>
        <translation>Das Bild hat zu viele Pixel und Kanäle.</translation>
    </message>
    <message>
        <source>Scale it down, or leave channels out.</source>
        <translation>Verkleinern Sie es, oder lassen Sie Kanäle weg.</translation>
    </message>
    <message>
        <source>Compare two pictures of one size, made for display.</source>
        <translation>Vergleichen Sie zwei Bilder gleicher Größe, die zur Anzeige gemacht sind.</translation>
    </message>
    <message>
        <source>Pictures of {} x {} and {} x {} cannot be compared.</source>
        <translation>Bilder von {} x {} und {} x {} können nicht verglichen werden.</translation>
    </message>
    <message>
        <source>Compare two pictures of one size, both in colour or both grey.</source>
        <translation>Vergleichen Sie zwei Bilder gleicher Größe, beide farbig oder beide grau.</translation>
    </message>
    <message>
        <source>Nothing of the series can be seen.</source>
        <translation>Von der Serie ist nichts zu sehen.</translation>
    </message>
    <message>
        <source>Choose another preset or clip.</source>
        <translation>Wählen Sie eine andere Voreinstellung oder einen anderen Beschnitt.</translation>
    </message>
    <message>
        <source>preview only</source>
        <translation>nur Vorschau</translation>
    </message>
    <message>
        <source>preview around the sharp centre</source>
        <translation>Vorschau um die scharfe Mitte</translation>
    </message>
    <message>
        <source>sharp centre traced {:.1f} s ago with {} samples</source>
        <translation>scharfe Mitte vor {:.1f} s mit {} Abtastungen verfolgt</translation>
    </message>
    <message>
        <source>estimated from the values</source>
        <translation>aus den Werten geschätzt</translation>
    </message>
    <message>
        <source>values on cut faces only coarsely</source>
        <translation>Werte auf Schnittflächen nur grob</translation>
    </message>
    <message>
        <source>the preview is not sharp enough after {} steps</source>
        <translation>die Vorschau ist nach {} Schritten nicht scharf genug</translation>
    </message>
    <message>
        <source>preview fades out</source>
        <translation>Vorschau blendet aus</translation>
    </message>
    <message>
        <source>preview where it is less noisy</source>
        <translation>Vorschau, wo sie weniger rauscht</translation>
    </message>
    <message>
        <source>1/{} of the pixels each way</source>
        <translation>1/{} der Pixel je Richtung</translation>
    </message>
    <message>
        <source>{} of {} samples</source>
        <translation>{} von {} Abtastungen</translation>
    </message>
    <message>
        <source>less than the full resolution</source>
        <translation>weniger als die volle Auflösung</translation>
    </message>
    <message>
        <source>denoised</source>
        <translation>entrauscht</translation>
    </message>
    <message>
        <source>{} samples left out</source>
        <translation>{} Abtastungen ausgelassen</translation>
    </message>
    <message>
        <source>There is not enough memory to write the model.</source>
        <translation>Es ist nicht genug Speicher da, um das Modell zu speichern.</translation>
    </message>
    <message>
        <source>The recording was cancelled.</source>
        <translation>Die Aufzeichnung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Wird geöffnet</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>In Bewegung</translation>
    </message>
    <message>
        <source>There is not enough memory for it.</source>
        <translation>Dafür ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Only what is path-traced has a peripheral model.</source>
        <translation>Nur was mit Pfadverfolgung gezeichnet ist, hat ein peripheres Modell.</translation>
    </message>
    <message>
        <source>Choose the look cinematic or clear.</source>
        <translation>Wählen Sie die Darstellung cinematic oder clear.</translation>
    </message>
    <message>
        <source>There is nothing to be seen that a model could learn.</source>
        <translation>Es ist nichts zu sehen, was ein Modell lernen könnte.</translation>
    </message>
    <message>
        <source>The graphics device has no memory for a model.</source>
        <translation>Das Grafikgerät hat keinen Speicher für ein Modell.</translation>
    </message>
    <message>
        <source>Close other programs, or show less of the volume.</source>
        <translation>Schließen Sie andere Programme, oder zeigen Sie weniger vom Volumen.</translation>
    </message>
    <message>
        <source>The model could not be made on this graphics device.</source>
        <translation>Das Modell konnte auf diesem Grafikgerät nicht erstellt werden.</translation>
    </message>
    <message>
        <source>Try another device.</source>
        <translation>Versuchen Sie ein anderes Gerät.</translation>
    </message>
    <message>
        <source>The graphics device stopped responding and was started again.</source>
        <translation>Das Grafikgerät hat nicht mehr geantwortet und wurde wieder gestartet.</translation>
    </message>
    <message>
        <source>There is no picture of this.</source>
        <translation>Davon gibt es kein Bild.</translation>
    </message>
    <message>
        <source>Draw it again; if that does not help, open another device.</source>
        <translation>Zeichnen Sie es noch einmal; wenn das nicht hilft, öffnen Sie ein anderes Gerät.</translation>
    </message>
    <message>
        <source>This was opened without a model.</source>
        <translation>Dies wurde ohne Modell geöffnet.</translation>
    </message>
    <message>
        <source>Open it with one.</source>
        <translation>Öffnen Sie es mit einem.</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>There is no model of what is shown yet.</source>
        <translation>Von dem, was gezeigt wird, gibt es noch kein Modell.</translation>
    </message>
    <message>
        <source>Train it first.</source>
        <translation>Trainieren Sie es zuerst.</translation>
    </message>
    <message>
        <source>No folder was given to keep models in.</source>
        <translation>Kein Ordner wurde angegeben, um Modelle zu behalten.</translation>
    </message>
    <message>
        <source>The model has learnt nothing yet that could be kept.</source>
        <translation>Das Modell hat noch nichts gelernt, was zu behalten wäre.</translation>
    </message>
    <message>
        <source>The stored model was not replaced: it has learnt more than this one, or could not be written.</source>
        <translation>Das gespeicherte Modell wurde nicht ersetzt: es hat mehr gelernt als dieses oder konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Train this one for longer, or check free space and permissions.</source>
        <translation>Trainieren Sie dieses länger, oder prüfen Sie freien Platz und Zugriffsrechte.</translation>
    </message>
    <message>
        <source>The model could not be kept.</source>
        <translation>Das Modell konnte nicht behalten werden.</translation>
    </message>
    <message>
        <source>Check free space and permissions of the folder that was given for models.</source>
        <translation>Prüfen Sie freien Platz und Zugriffsrechte des Ordners, der für Modelle angegeben wurde.</translation>
    </message>
    <message>
        <source>A handle of the graphics device that is lent is missing.</source>
        <translation>Ein Handle des geliehenen Grafikgeräts fehlt.</translation>
    </message>
    <message>
        <source>Give VkInstance, VkPhysicalDevice, VkDevice, and a VkQueue of it with compute.</source>
        <translation>Geben Sie VkInstance, VkPhysicalDevice, VkDevice und eine VkQueue davon an, die rechnen kann.</translation>
    </message>
    <message>
        <source>The queue that is lent can be locked, or unlocked, but not both.</source>
        <translation>Die geliehene Queue kann gesperrt oder freigegeben werden, aber nicht beides.</translation>
    </message>
    <message>
        <source>Give both functions, or neither.</source>
        <translation>Geben Sie beide Funktionen an, oder keine.</translation>
    </message>
    <message>
        <source>The model&apos;s name says no format.</source>
        <translation>Der Name des Modells nennt kein Format.</translation>
    </message>
    <message>
        <source>The name says no format that splats alone are written in.</source>
        <translation>Der Name nennt kein Format, in dem Splats allein geschrieben werden.</translation>
    </message>
    <message>
        <source>The model has learnt nothing yet that training could go on with.</source>
        <translation>Das Modell hat noch nichts gelernt, womit das Training weitergehen könnte.</translation>
    </message>
    <message>
        <source>Wait until the picture converges, or save it as .ply, .spz or .glb.</source>
        <translation>Warten Sie, bis das Bild besser wird, oder speichern Sie es als .ply, .spz oder .glb.</translation>
    </message>
    <message>
        <source>The model could not be written.</source>
        <translation>Das Modell konnte nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Writing the model</source>
        <translation>Das Modell wird gespeichert</translation>
    </message>
    <message>
        <source>What goes on learning needs linear colours.</source>
        <translation>Was weiterlernt, braucht lineare Farben.</translation>
    </message>
    <message>
        <source>Save it as .ply, .spz or .glb, or without colours as displayed.</source>
        <translation>Speichern Sie es als .ply, .spz oder .glb, oder ohne Farben wie gezeigt.</translation>
    </message>
    <message>
        <source>Stopped before the first step; nothing was written.</source>
        <translation>Vor dem ersten Schritt angehalten; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>The saved training has no views to learn from.</source>
        <translation>Das gespeicherte Training hat keine Ansichten, aus denen zu lernen wäre.</translation>
    </message>
    <message>
        <source>Train anew, with --views above 0.</source>
        <translation>Trainieren Sie neu, mit --views über 0.</translation>
    </message>
    <message>
        <source>The saved training has all of its {} steps.</source>
        <translation>Das gespeicherte Training hat alle seine {} Schritte.</translation>
    </message>
    <message>
        <source>Give --iterations for as many more.</source>
        <translation>Geben Sie mit --iterations an, wie viele es noch sein sollen.</translation>
    </message>
    <message>
        <source>The saved training does not say what its pictures show.</source>
        <translation>Das gespeicherte Training sagt nicht, was seine Bilder zeigen.</translation>
    </message>
    <message>
        <source>It is of another program, or of an older one: train anew.</source>
        <translation>Es ist von einem anderen Programm oder von einem älteren: trainieren Sie neu.</translation>
    </message>
    <message>
        <source>The saved training is of {}.</source>
        <translation>Das gespeicherte Training ist von {}.</translation>
    </message>
    <message>
        <source>The measurement was stopped.</source>
        <translation>Die Messung wurde angehalten.</translation>
    </message>
    <message>
        <source>Measuring this machine</source>
        <translation>Dieser Rechner wird gemessen</translation>
    </message>
    <message>
        <source>Stored sessions were not changed, because Macula found a mistake of its own.</source>
        <translation>Die gespeicherten Sitzungen wurden nicht geändert, weil Macula einen eigenen Fehler gefunden hat.</translation>
    </message>
    <message>
        <source>A stored model is damaged, and is not used.</source>
        <translation>Ein gespeichertes Modell ist beschädigt und wird nicht verwendet.</translation>
    </message>
    <message>
        <source>`macula sessions verify` says what else is.</source>
        <translation>`macula sessions verify` sagt, was es noch ist.</translation>
    </message>
    <message>
        <source>How this study was left was not found in time.</source>
        <translation>Wie diese Studie verlassen wurde, wurde nicht rechtzeitig gefunden.</translation>
    </message>
    <message>
        <source>It is kept: open the study again to see it.</source>
        <translation>Es bleibt aufbewahrt: öffnen Sie die Studie noch einmal, um es zu sehen.</translation>
    </message>
    <message>
        <source>More was measured on this study than is shown here: another window has it open, or had.</source>
        <translation>An dieser Studie wurde mehr gemessen, als hier gezeigt wird: ein anderes Fenster hat sie offen oder hatte sie offen.</translation>
    </message>
    <message>
        <source>All of it is kept; open the study again to see it.</source>
        <translation>Alles davon bleibt aufbewahrt; öffnen Sie die Studie noch einmal, um es zu sehen.</translation>
    </message>
    <message>
        <source>The name has letters that cannot be read.</source>
        <translation>Der Name hat Buchstaben, die nicht gelesen werden können.</translation>
    </message>
    <message>
        <source>Type it anew.</source>
        <translation>Geben Sie ihn neu ein.</translation>
    </message>
    <message>
        <source>The name has letters that cannot be seen.</source>
        <translation>Der Name hat Buchstaben, die nicht zu sehen sind.</translation>
    </message>
    <message>
        <source>Type it anew, without pasting.</source>
        <translation>Geben Sie ihn neu ein, ohne einzufügen.</translation>
    </message>
    <message>
        <source>The preset needs a name.</source>
        <translation>Die Voreinstellung braucht einen Namen.</translation>
    </message>
    <message>
        <source>Type one.</source>
        <translation>Geben Sie einen ein.</translation>
    </message>
    <message>
        <source>The name is too long.</source>
        <translation>Der Name ist zu lang.</translation>
    </message>
    <message>
        <source>Use at most {} letters.</source>
        <translation>Nehmen Sie höchstens {} Buchstaben.</translation>
    </message>
    <message>
        <source>It is too large.</source>
        <translation>Sie ist zu groß.</translation>
    </message>
    <message>
        <source>There is a preset of that name already.</source>
        <translation>Eine Voreinstellung dieses Namens gibt es schon.</translation>
    </message>
    <message>
        <source>There are too many presets of your own.</source>
        <translation>Es gibt zu viele eigene Voreinstellungen.</translation>
    </message>
    <message>
        <source>Delete some first.</source>
        <translation>Löschen Sie zuerst einige.</translation>
    </message>
    <message>
        <source>The camera cannot be kept: a part of it would be lost.</source>
        <translation>Die Kamera kann nicht behalten werden: ein Teil von ihr ginge verloren.</translation>
    </message>
    <message>
        <source>Keep the curve alone.</source>
        <translation>Behalten Sie nur die Kurve.</translation>
    </message>
    <message>
        <source>A built-in preset cannot be renamed.</source>
        <translation>Eine eingebaute Voreinstellung kann nicht umbenannt werden.</translation>
    </message>
    <message>
        <source>Save a copy of it.</source>
        <translation>Speichern Sie eine Kopie davon.</translation>
    </message>
    <message>
        <source>An export cannot lie inside of the stored sessions.</source>
        <translation>Ein Export kann nicht innerhalb der gespeicherten Sitzungen liegen.</translation>
    </message>
    <message>
        <source>Choose a place elsewhere.</source>
        <translation>Wählen Sie einen Ort anderswo.</translation>
    </message>
    <message>
        <source>These are the stored sessions themselves.</source>
        <translation>Das sind die gespeicherten Sitzungen selbst.</translation>
    </message>
    <message>
        <source>Choose a folder that macula sessions export wrote.</source>
        <translation>Wählen Sie einen Ordner, den macula sessions export geschrieben hat.</translation>
    </message>
    <message>
        <source>{} left, because models of theirs are open. Close other windows of Macula and purge once more.</source>
        <translation>{} belassen, weil Modelle davon offen sind. Schließen Sie andere Fenster von Macula, und bereinigen Sie noch einmal.</translation>
    </message>
    <message>
        <source>{} of damaged files may hold parts of what was deleted; --damaged-too deletes them as well.</source>
        <translation>Ordner mit beschädigten Dateien, die Teile des Gelöschten enthalten können: {}; --damaged-too löscht auch diese.</translation>
    </message>
    <message>
        <source>The file of stored sessions was damaged. {}, among them {} and {}, were rescued; the damaged file is kept in {}.</source>
        <translation>Die Datei der gespeicherten Sitzungen war beschädigt. Gerettet wurden {}, darunter {} und {}; die beschädigte Datei wird in {} aufbewahrt.</translation>
    </message>
    <message>
        <source>Stored sessions were brought to the format of this version; older ones cannot read them now.</source>
        <translation>Gespeicherte Sitzungen wurden in das Format dieser Version gebracht; ältere können sie nun nicht lesen.</translation>
    </message>
    <message>
        <source>Other users of this computer may be able to read stored sessions.</source>
        <translation>Andere Benutzer dieses Rechners können gespeicherte Sitzungen vielleicht lesen.</translation>
    </message>
    <message>
        <source>The file of stored sessions was damaged. It was set aside, and what could be read of it was rescued.</source>
        <translation>Die Datei der gespeicherten Sitzungen war beschädigt. Sie wurde beiseitegelegt, und was davon lesbar war, wurde gerettet.</translation>
    </message>
    <message>
        <source>`macula sessions verify` says what is there.</source>
        <translation>`macula sessions verify` sagt, was da ist.</translation>
    </message>
    <message>
        <source>{} studies begin with {}.</source>
        <translation>{} Studien beginnen mit {}.</translation>
    </message>
    <message>
        <source>Give more digits: {}.</source>
        <translation>Geben Sie mehr Ziffern an: {}.</translation>
    </message>
    <message>
        <source>Nothing is stored yet.</source>
        <translation>Noch ist nichts gespeichert.</translation>
    </message>
    <message>
        <source>Check --folder if you expected studies here.</source>
        <translation>Prüfen Sie --folder, wenn Sie hier Studien erwartet haben.</translation>
    </message>
    <message>
        <source>A study is named by the first {} or more of its digits, 0 to 9 and a to f.</source>
        <translation>Eine Studie wird durch die ersten {} oder mehr ihrer Ziffern benannt, 0 bis 9 und a bis f.</translation>
    </message>
    <message>
        <source>No stored study begins with {}.</source>
        <translation>Keine gespeicherte Studie beginnt mit {}.</translation>
    </message>
    <message>
        <source>The segments of the view are not here; all of the volume is shown.</source>
        <translation>Die Segmente der Ansicht fehlen hier; das ganze Volumen wird gezeigt.</translation>
    </message>
    <message>
        <source>The view has a second volume in the picture; give it by --second to draw both.</source>
        <translation>Die Ansicht hat ein zweites Volumen im Bild; geben Sie es mit --second an, um beide zu zeichnen.</translation>
    </message>
    <message>
        <source>--second does nothing in this look: it is of all but projections.</source>
        <translation>--second bewirkt in dieser Darstellung nichts: es gehört zu allen außer Projektionen.</translation>
    </message>
    <message>
        <source>Only a folder of DICOM files can have segmentations.</source>
        <translation>Nur ein Ordner mit DICOM-Dateien kann Segmentierungen haben.</translation>
    </message>
    <message>
        <source>Tracing</source>
        <translation>Pfade werden verfolgt</translation>
    </message>
    <message>
        <source>Tracing until the noise is gone</source>
        <translation>Verfolgt, bis das Rauschen weg ist</translation>
    </message>
    <message>
        <source>{} of the model&apos;s splats hold what is no number or no rotation, or are so large that they would fill every picture: left out.</source>
        <translation>{} der Splats des Modells enthalten, was keine Zahl oder keine Drehung ist, oder sind so groß, dass sie jedes Bild füllten: weggelassen.</translation>
    </message>
    <message>
        <source>The model holds no splats: the pictures are empty.</source>
        <translation>Das Modell enthält keine Splats: die Bilder sind leer.</translation>
    </message>
    <message>
        <source>This model is one of Macula&apos;s and has a low-pass of its own: --low-pass does nothing.</source>
        <translation>Dieses Modell ist von Macula und hat einen eigenen Tiefpass: --low-pass bewirkt nichts.</translation>
    </message>
    <message>
        <source>There is a folder of that name.</source>
        <translation>Es gibt einen Ordner dieses Namens.</translation>
    </message>
    <message>
        <source>Nothing can be written there.</source>
        <translation>Dort kann nichts geschrieben werden.</translation>
    </message>
    <message>
        <source>The file is one of those that are read.</source>
        <translation>Die Datei ist eine von denen, die gelesen werden.</translation>
    </message>
    <message>
        <source>Choose another name: what is read is never replaced.</source>
        <translation>Wählen Sie einen anderen Namen: was gelesen wird, wird nie ersetzt.</translation>
    </message>
    <message>
        <source>The file belongs to the folder that is read.</source>
        <translation>Die Datei gehört zu dem Ordner, der gelesen wird.</translation>
    </message>
    <message>
        <source>The file exists already.</source>
        <translation>Die Datei gibt es schon.</translation>
    </message>
    <message>
        <source>Give --overwrite to replace it, or choose another name.</source>
        <translation>Geben Sie --overwrite an, um sie zu ersetzen, oder wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Two outputs have the same name.</source>
        <translation>Zwei Ausgaben haben denselben Namen.</translation>
    </message>
    <message>
        <source>Give each a name of its own.</source>
        <translation>Geben Sie jeder einen eigenen Namen.</translation>
    </message>
    <message>
        <source>The folder for the pictures cannot be made.</source>
        <translation>Der Ordner für die Bilder kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>The diameter of the lens is not usable.</source>
        <translation>Der Durchmesser der Linse ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give 0 to {:g} mm; 0 is none.</source>
        <translation>Geben Sie 0 bis {:g} mm an; 0 ist keine.</translation>
    </message>
    <message>
        <source>The distance of what is sharp is not usable.</source>
        <translation>Die Entfernung des Scharfen ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give a number above 0, up to {:g} mm, or auto.</source>
        <translation>Geben Sie eine Zahl über 0, bis {:g} mm, oder auto an.</translation>
    </message>
    <message>
        <source>The depth of the fog is not usable.</source>
        <translation>Die Tiefe des Nebels ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give {:g} to {:g} mm, or 0 for none.</source>
        <translation>Geben Sie {:g} bis {:g} mm an, oder 0 für keinen.</translation>
    </message>
    <message>
        <source>The middle of the picture shows nothing that a lens could be focused on.</source>
        <translation>Die Bildmitte zeigt nichts, worauf eine Linse scharf gestellt werden könnte.</translation>
    </message>
    <message>
        <source>Move the camera, or give the distance in mm of what is to be sharp: --focus-mm.</source>
        <translation>Bewegen Sie die Kamera, oder geben Sie die Entfernung dessen, was scharf sein soll, in mm an: --focus-mm.</translation>
    </message>
    <message>
        <source>The camera stands in what the middle of the picture shows.</source>
        <translation>Die Kamera steht in dem, was die Bildmitte zeigt.</translation>
    </message>
    <message>
        <source>The picture must be a .png or .exr file.</source>
        <translation>Das Bild muss eine .png- oder .exr-Datei sein.</translation>
    </message>
    <message>
        <source>Give -o a name with one of these endings.</source>
        <translation>Geben Sie -o einen Namen mit einer dieser Endungen.</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Wird gezeichnet</translation>
    </message>
    <message>
        <source>The small picture was not drawn.</source>
        <translation>Das kleine Bild wurde nicht gezeichnet.</translation>
    </message>
    <message>
        <source>There is not enough memory for small pictures of presets.</source>
        <translation>Für kleine Bilder der Voreinstellungen ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Every voxel of the series is padding: there is nothing to draw.</source>
        <translation>Jedes Voxel der Serie ist Füllwert: es gibt nichts zu zeichnen.</translation>
    </message>
    <message>
        <source>Open another series.</source>
        <translation>Öffnen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>The folder is not empty.</source>
        <translation>Der Ordner ist nicht leer.</translation>
    </message>
    <message>
        <source>Choose another one, or empty it.</source>
        <translation>Wählen Sie einen anderen, oder leeren Sie ihn.</translation>
    </message>
    <message>
        <source>The folder cannot be made.</source>
        <translation>Der Ordner kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Wählen Sie einen anderen Ort.</translation>
    </message>
    <message>
        <source>{} does nothing in this look: it is of {}.</source>
        <translation>{} bewirkt in dieser Darstellung nichts: es gehört zu {}.</translation>
    </message>
    <message>
        <source>{} does nothing, as the preset has no curves for steep matter.</source>
        <translation>{} bewirkt nichts, da die Voreinstellung keine Kurven für steile Materie hat.</translation>
    </message>
    <message>
        <source>{} does nothing, as the preset has no surface: --surface gives it one.</source>
        <translation>{} bewirkt nichts, da die Voreinstellung keine Oberfläche hat: --surface gibt ihr eine.</translation>
    </message>
    <message>
        <source>--focus-mm does nothing without --lens-mm: all is sharp.</source>
        <translation>--focus-mm bewirkt ohne --lens-mm nichts: alles ist scharf.</translation>
    </message>
    <message>
        <source>This look is never denoised: --denoise does nothing.</source>
        <translation>Diese Darstellung wird nie entrauscht: --denoise bewirkt nichts.</translation>
    </message>
    <message>
        <source>--background does nothing in an EXR, which has coverage instead.</source>
        <translation>--background bewirkt in einer EXR nichts; sie hat stattdessen eine Abdeckung.</translation>
    </message>
    <message>
        <source>--keep-unfinished does nothing without --error: nothing is written when stopped.</source>
        <translation>--keep-unfinished bewirkt ohne --error nichts: beim Anhalten wird nichts geschrieben.</translation>
    </message>
    <message>
        <source>A picture of light has no cube, scale and letters over it.</source>
        <translation>Über einem Bild aus Licht liegen weder Würfel noch Maßstab und Buchstaben.</translation>
    </message>
    <message>
        <source>The picture cannot have that size.</source>
        <translation>Das Bild kann diese Größe nicht haben.</translation>
    </message>
    <message>
        <source>Take 1 to {} pixels for each side.</source>
        <translation>Nehmen Sie 1 bis {} Pixel für jede Seite.</translation>
    </message>
    <message>
        <source>A sequence cannot have that many pictures.</source>
        <translation>So viele Bilder kann eine Folge nicht haben.</translation>
    </message>
    <message>
        <source>Take 1 to {}.</source>
        <translation>Nehmen Sie 1 bis {}.</translation>
    </message>
    <message>
        <source>The way of the camera has no view.</source>
        <translation>Die Kamerafahrt hat keine Ansicht.</translation>
    </message>
    <message>
        <source>Add one first.</source>
        <translation>Fügen Sie zuerst eine hinzu.</translation>
    </message>
    <message>
        <source>The folder holds pictures of another sequence.</source>
        <translation>Der Ordner enthält Bilder einer anderen Folge.</translation>
    </message>
    <message>
        <source>Choose an empty folder, or make a new one.</source>
        <translation>Wählen Sie einen leeren Ordner, oder legen Sie einen neuen an.</translation>
    </message>
    <message>
        <source>Drawing pictures</source>
        <translation>Bilder werden gezeichnet</translation>
    </message>
    <message>
        <source>The device {} was opened without what Macula needs of it.</source>
        <translation>Das Gerät {} wurde ohne das geöffnet, was Macula von ihm braucht.</translation>
    </message>
    <message>
        <source>Open it with VK_KHR_push_descriptor.</source>
        <translation>Öffnen Sie es mit VK_KHR_push_descriptor.</translation>
    </message>
    <message>
        <source>The device {} cannot be used: {}.</source>
        <translation>Das Gerät {} kann nicht verwendet werden: {}.</translation>
    </message>
    <message>
        <source>Update its driver, or choose another device.</source>
        <translation>Aktualisieren Sie seinen Treiber, oder wählen Sie ein anderes Gerät.</translation>
    </message>
    <message>
        <source>There is no graphics device &quot;{}&quot;.</source>
        <translation>Es gibt kein Grafikgerät „{}“.</translation>
    </message>
    <message>
        <source>Choose one by its number or a part of its name: {}</source>
        <translation>Wählen Sie eines nach seiner Nummer oder einem Teil seines Namens: {}</translation>
    </message>
    <message>
        <source>The graphics device that was lent is not one of its VkInstance.</source>
        <translation>Das geliehene Grafikgerät ist keines seiner VkInstance.</translation>
    </message>
    <message>
        <source>Give the VkInstance and the VkPhysicalDevice that the device was made of.</source>
        <translation>Geben Sie die VkInstance und das VkPhysicalDevice an, aus denen das Gerät gemacht ist.</translation>
    </message>
    <message>
        <source>The headset asks for a graphics device that is not there.</source>
        <translation>Das Headset verlangt ein Grafikgerät, das es nicht gibt.</translation>
    </message>
    <message>
        <source>Restart the headset&apos;s software.</source>
        <translation>Starten Sie die Software des Headsets neu.</translation>
    </message>
    <message>
        <source>The program that lends a graphics device gave none.</source>
        <translation>Das Programm, das ein Grafikgerät leiht, gab keines.</translation>
    </message>
    <message>
        <source>Give a device, a queue of it, and what it was made of.</source>
        <translation>Geben Sie ein Gerät, eine Queue davon und das an, woraus es gemacht ist.</translation>
    </message>
    <message>
        <source>The queue that was lent is of a family that cannot compute.</source>
        <translation>Die geliehene Queue ist von einer Familie, die nicht rechnen kann.</translation>
    </message>
    <message>
        <source>Give a queue with compute, and the number of its family.</source>
        <translation>Geben Sie eine Queue, die rechnen kann, und die Nummer ihrer Familie an.</translation>
    </message>
    <message>
        <source>The device {} does not offer {}.</source>
        <translation>Das Gerät {} bietet {} nicht.</translation>
    </message>
    <message>
        <source>Update its driver, or choose another device with MACULA_DEVICE.</source>
        <translation>Aktualisieren Sie seinen Treiber, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>This program has as many files open as it may, so what is shared cannot be opened.</source>
        <translation>Dieses Programm hat so viele Dateien offen, wie es darf; was geteilt wird, kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>Close what is not needed, or let the program open more files (ulimit -n).</source>
        <translation>Schließen Sie, was nicht gebraucht wird, oder lassen Sie das Programm mehr Dateien öffnen (ulimit -n).</translation>
    </message>
    <message>
        <source>A file descriptor of what is shared is not open.</source>
        <translation>Ein Dateideskriptor dessen, was geteilt wird, ist nicht offen.</translation>
    </message>
    <message>
        <source>Give one that vkGetMemoryFdKHR or vkGetSemaphoreFdKHR made, and close it afterwards.</source>
        <translation>Geben Sie einen an, den vkGetMemoryFdKHR oder vkGetSemaphoreFdKHR gemacht hat, und schließen Sie ihn danach.</translation>
    </message>
    <message>
        <source>There is no Vulkan driver on this computer, so nothing can be rendered.</source>
        <translation>Auf diesem Rechner ist kein Vulkan-Treiber, also kann nichts gezeichnet werden.</translation>
    </message>
    <message>
        <source>Install the driver of the graphics card, or, to render on the CPU, the Debian/Ubuntu package mesa-vulkan-drivers: sudo apt install mesa-vulkan-drivers</source>
        <translation>Installieren Sie den Treiber der Grafikkarte oder, um auf dem Prozessor zu zeichnen, das Debian-/Ubuntu-Paket mesa-vulkan-drivers: sudo apt install mesa-vulkan-drivers</translation>
    </message>
    <message>
        <source>The Vulkan validation layer was asked for, but is not installed.</source>
        <translation>Die Prüfschicht von Vulkan wurde verlangt, ist aber nicht installiert.</translation>
    </message>
    <message>
        <source>Install it (Debian/Ubuntu: sudo apt install vulkan-validationlayers), or unset MACULA_VALIDATION.</source>
        <translation>Installieren Sie sie (Debian/Ubuntu: sudo apt install vulkan-validationlayers), oder entfernen Sie MACULA_VALIDATION.</translation>
    </message>
    <message>
        <source>The Vulkan driver of this computer does not offer {}.</source>
        <translation>Der Vulkan-Treiber dieses Rechners bietet {} nicht.</translation>
    </message>
    <message>
        <source>Update the graphics driver.</source>
        <translation>Aktualisieren Sie den Grafiktreiber.</translation>
    </message>
    <message>
        <source>The graphics device stopped responding {} times within a minute.</source>
        <translation>Das Grafikgerät hat innerhalb einer Minute {}-mal nicht mehr geantwortet.</translation>
    </message>
    <message>
        <source>Update the graphics driver, or choose another device: `macula devices` lists them, --device or MACULA_DEVICE takes one. The processor (llvmpipe) is slow but always there.</source>
        <translation>Aktualisieren Sie den Grafiktreiber, oder wählen Sie ein anderes Gerät: `macula devices` zählt sie auf, --device oder MACULA_DEVICE nimmt eines. Der Prozessor (llvmpipe) ist langsam, aber immer da.</translation>
    </message>
    <message>
        <source>The {} does not fit on the device {}: it needs {}, and the device allows {}.</source>
        <translation>{} passt nicht auf das Gerät {}: nötig sind {}, und das Gerät erlaubt {}.</translation>
    </message>
    <message>
        <source>Open a smaller series, or choose a device with more memory by MACULA_DEVICE.</source>
        <translation>Öffnen Sie eine kleinere Serie, oder wählen Sie mit MACULA_DEVICE ein Gerät mit mehr Speicher.</translation>
    </message>
    <message>
        <source>The shared image is of another graphics card, or another driver, than {}, which draws.</source>
        <translation>Das geteilte Bild ist von einer anderen Grafikkarte oder einem anderen Treiber als {}, das zeichnet.</translation>
    </message>
    <message>
        <source>Ask macula_device_identify which card draws, and make the image on that one.</source>
        <translation>Fragen Sie macula_device_identify, welche Karte zeichnet, und machen Sie das Bild auf dieser.</translation>
    </message>
    <message>
        <source>The device {} was opened without what images are shared by.</source>
        <translation>Das Gerät {} wurde ohne das geöffnet, womit Bilder geteilt werden.</translation>
    </message>
    <message>
        <source>Open it with VK_KHR_external_memory_fd; where it does not offer that, have pictures in memory.</source>
        <translation>Öffnen Sie es mit VK_KHR_external_memory_fd; wo es das nicht bietet, nehmen Sie Bilder im Speicher.</translation>
    </message>
    <message>
        <source>The device {} cannot open a shared image like this.</source>
        <translation>Das Gerät {} kann ein solches geteiltes Bild nicht öffnen.</translation>
    </message>
    <message>
        <source>Share one of VK_FORMAT_R8G8B8A8_UNORM with optimal tiling, and for fewer uses.</source>
        <translation>Teilen Sie eines in VK_FORMAT_R8G8B8A8_UNORM mit optimaler Kachelung, und für weniger Verwendungen.</translation>
    </message>
    <message>
        <source>The device {} shares an image only with memory of its own.</source>
        <translation>Das Gerät {} teilt ein Bild nur mit eigenem Speicher.</translation>
    </message>
    <message>
        <source>Allocate it with VkMemoryDedicatedAllocateInfo, and say so.</source>
        <translation>Belegen Sie ihn mit VkMemoryDedicatedAllocateInfo, und sagen Sie das.</translation>
    </message>
    <message>
        <source>The shared image needs {} bytes at a multiple of {}, and has {} at {}.</source>
        <translation>Das geteilte Bild braucht {} Bytes an einem Vielfachen von {} und hat {} bei {}.</translation>
    </message>
    <message>
        <source>The memory is said to be the shared image&apos;s alone, which needs {} bytes and not {}.</source>
        <translation>Der Speicher soll dem geteilten Bild allein gehören, das {} Bytes braucht und nicht {}.</translation>
    </message>
    <message>
        <source>The shared image needs memory of its own, and is said to have none.</source>
        <translation>Das geteilte Bild braucht eigenen Speicher und soll keinen haben.</translation>
    </message>
    <message>
        <source>The shared image cannot lie in memory of type {}.</source>
        <translation>Das geteilte Bild kann nicht in Speicher vom Typ {} liegen.</translation>
    </message>
    <message>
        <source>Give VkMemoryAllocateInfo::memoryTypeIndex of the memory that is shared.</source>
        <translation>Geben Sie VkMemoryAllocateInfo::memoryTypeIndex des Speichers an, der geteilt wird.</translation>
    </message>
    <message>
        <source>The device {} has no {} of memory that could be shared.</source>
        <translation>Das Gerät {} hat keine {} Speicher, die geteilt werden könnten.</translation>
    </message>
    <message>
        <source>What was shared is no memory of this graphics card, or smaller than it is said to be.</source>
        <translation>Was geteilt wurde, ist kein Speicher dieser Grafikkarte, oder kleiner als angegeben.</translation>
    </message>
    <message>
        <source>Give a file descriptor of vkGetMemoryFdKHR with VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT, and the size of the allocation.</source>
        <translation>Geben Sie einen Dateideskriptor von vkGetMemoryFdKHR mit VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT und die Größe der Belegung an.</translation>
    </message>
    <message>
        <source>The device {} cannot share semaphores with another program.</source>
        <translation>Das Gerät {} kann keine Semaphore mit einem anderen Programm teilen.</translation>
    </message>
    <message>
        <source>The device {} was opened without what semaphores are shared by.</source>
        <translation>Das Gerät {} wurde ohne das geöffnet, womit Semaphore geteilt werden.</translation>
    </message>
    <message>
        <source>What was shared as a semaphore is none of this graphics card.</source>
        <translation>Was als Semaphor geteilt wurde, ist keines dieser Grafikkarte.</translation>
    </message>
    <message>
        <source>Give a file descriptor of vkGetSemaphoreFdKHR with VK_EXTERNAL_SEMAPHORE_HANDLE_TYPE_OPAQUE_FD_BIT.</source>
        <translation>Geben Sie einen Dateideskriptor von vkGetSemaphoreFdKHR mit VK_EXTERNAL_SEMAPHORE_HANDLE_TYPE_OPAQUE_FD_BIT an.</translation>
    </message>
    <message>
        <source>An image of {} x {} pixels cannot be shared.</source>
        <translation>Ein Bild von {} x {} Pixeln kann nicht geteilt werden.</translation>
    </message>
    <message>
        <source>Give one of 1 to {} pixels a side.</source>
        <translation>Geben Sie eines mit 1 bis {} Pixeln je Seite an.</translation>
    </message>
    <message>
        <source>The pixels of the shared image are of a kind that Macula does not write.</source>
        <translation>Die Pixel des geteilten Bildes sind von einer Art, die Macula nicht schreibt.</translation>
    </message>
    <message>
        <source>Share one of VK_FORMAT_R8G8B8A8_UNORM or VK_FORMAT_R8G8B8A8_SRGB.</source>
        <translation>Teilen Sie eines in VK_FORMAT_R8G8B8A8_UNORM oder VK_FORMAT_R8G8B8A8_SRGB.</translation>
    </message>
    <message>
        <source>The tiling of the shared image is not known.</source>
        <translation>Die Kachelung des geteilten Bildes ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Share one of VK_IMAGE_TILING_OPTIMAL or VK_IMAGE_TILING_LINEAR.</source>
        <translation>Teilen Sie eines mit VK_IMAGE_TILING_OPTIMAL oder VK_IMAGE_TILING_LINEAR.</translation>
    </message>
    <message>
        <source>The shared image was not made for being written to, or for more than is known.</source>
        <translation>Das geteilte Bild ist nicht dafür gemacht, beschrieben zu werden, oder für mehr, als bekannt ist.</translation>
    </message>
    <message>
        <source>Make it with VK_IMAGE_USAGE_TRANSFER_DST_BIT, and no more than transfers, sampling, storage, and attachments of colour.</source>
        <translation>Machen Sie es mit VK_IMAGE_USAGE_TRANSFER_DST_BIT, und für nicht mehr als Übertragen, Abtasten, Speichern und als Farbziel.</translation>
    </message>
    <message>
        <source>The shared image was made with flags that Macula does not know.</source>
        <translation>Das geteilte Bild ist mit Flags gemacht, die Macula nicht kennt.</translation>
    </message>
    <message>
        <source>Use no more than those for a mutable format, extended usage and aliases.</source>
        <translation>Nehmen Sie nur die für ein änderbares Format, erweiterte Verwendung und Aliase.</translation>
    </message>
    <message>
        <source>The shared image cannot be left in the layout that was asked for.</source>
        <translation>Das geteilte Bild kann nicht im verlangten Layout hinterlassen werden.</translation>
    </message>
    <message>
        <source>Ask for VK_IMAGE_LAYOUT_GENERAL, or for a layout of something that the image was made for.</source>
        <translation>Verlangen Sie VK_IMAGE_LAYOUT_GENERAL oder ein Layout für etwas, wofür das Bild gemacht ist.</translation>
    </message>
    <message>
        <source>No memory was shared.</source>
        <translation>Kein Speicher wurde geteilt.</translation>
    </message>
    <message>
        <source>Give a file descriptor of vkGetMemoryFdKHR, above 0.</source>
        <translation>Geben Sie einen Dateideskriptor von vkGetMemoryFdKHR an, über 0.</translation>
    </message>
    <message>
        <source>The shared memory of {} bytes has no room for an image of {} x {} pixels at byte {}.</source>
        <translation>Der geteilte Speicher von {} Bytes hat keinen Platz für ein Bild von {} x {} Pixeln ab Byte {}.</translation>
    </message>
    <message>
        <source>Give VkMemoryAllocateInfo::allocationSize, and the offset that the image was bound at.</source>
        <translation>Geben Sie VkMemoryAllocateInfo::allocationSize und den Versatz an, an den das Bild gebunden ist.</translation>
    </message>
    <message>
        <source>A dedicated allocation has its image at the beginning, and this one has not.</source>
        <translation>Bei einer eigenen Belegung liegt das Bild am Anfang, und bei dieser nicht.</translation>
    </message>
    <message>
        <source>Give the offset 0, or share memory that is not dedicated.</source>
        <translation>Geben Sie den Versatz 0 an, oder teilen Sie Speicher, der nicht eigens belegt ist.</translation>
    </message>
    <message>
        <source>The shared memory is of a type that does not exist.</source>
        <translation>Der geteilte Speicher ist von einem Typ, den es nicht gibt.</translation>
    </message>
    <message>
        <source>Give VkMemoryAllocateInfo::memoryTypeIndex.</source>
        <translation>Geben Sie VkMemoryAllocateInfo::memoryTypeIndex an.</translation>
    </message>
    <message>
        <source>It was not said which graphics card the shared memory is of.</source>
        <translation>Es wurde nicht gesagt, von welcher Grafikkarte der geteilte Speicher ist.</translation>
    </message>
    <message>
        <source>Give deviceUUID and driverUUID of VkPhysicalDeviceIDProperties.</source>
        <translation>Geben Sie deviceUUID und driverUUID aus VkPhysicalDeviceIDProperties an.</translation>
    </message>
    <message>
        <source>What was shared as {} is a file, a pipe, a socket or a folder, and no {}.</source>
        <translation>Was als {} geteilt wurde, ist eine Datei, eine Pipe, ein Socket oder ein Ordner, und kein {}.</translation>
    </message>
    <message>
        <source>Give a file descriptor of {}.</source>
        <translation>Geben Sie einen Dateideskriptor von {} an.</translation>
    </message>
    <message>
        <source>A shader cannot be used: {}.</source>
        <translation>Ein Shader kann nicht verwendet werden: {}.</translation>
    </message>
    <message>
        <source>Build Macula again.</source>
        <translation>Bauen Sie Macula neu.</translation>
    </message>
    <message>
        <source>The device {} cannot draw in this window.</source>
        <translation>Das Gerät {} kann nicht in diesem Fenster zeichnen.</translation>
    </message>
    <message>
        <source>Choose the device that drives the display by MACULA_DEVICE.</source>
        <translation>Wählen Sie mit MACULA_DEVICE das Gerät, das die Anzeige treibt.</translation>
    </message>
    <message>
        <source>Could not {}: the computer&apos;s memory is full.</source>
        <translation>Fehler ({}): der Speicher des Rechners ist voll.</translation>
    </message>
    <message>
        <source>Close other programs, or open a smaller series.</source>
        <translation>Schließen Sie andere Programme, oder öffnen Sie eine kleinere Serie.</translation>
    </message>
    <message>
        <source>Could not {}: the graphics memory is full.</source>
        <translation>Fehler ({}): der Grafikspeicher ist voll.</translation>
    </message>
    <message>
        <source>Close other programs that draw in 3D, open a smaller series, or choose another device with MACULA_DEVICE.</source>
        <translation>Schließen Sie andere Programme, die in 3D zeichnen, öffnen Sie eine kleinere Serie, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>Could not {}: the graphics device stopped responding and was reset.</source>
        <translation>Fehler ({}): das Grafikgerät hat nicht mehr geantwortet und wurde zurückgesetzt.</translation>
    </message>
    <message>
        <source>Try again. If this comes back, update the graphics driver, or choose another device with MACULA_DEVICE.</source>
        <translation>Versuchen Sie es noch einmal. Wenn das wieder vorkommt, aktualisieren Sie den Grafiktreiber, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>Could not {}: the window system took the window away.</source>
        <translation>Fehler ({}): das Fenstersystem hat das Fenster weggenommen.</translation>
    </message>
    <message>
        <source>Open the window again.</source>
        <translation>Öffnen Sie das Fenster noch einmal.</translation>
    </message>
    <message>
        <source>Could not {}: the graphics driver reports {}.</source>
        <translation>Fehler ({}): der Grafiktreiber meldet {}.</translation>
    </message>
    <message>
        <source>Update the graphics driver, or choose another device with MACULA_DEVICE.</source>
        <translation>Aktualisieren Sie den Grafiktreiber, oder wählen Sie mit MACULA_DEVICE ein anderes Gerät.</translation>
    </message>
    <message>
        <source>Light is learnt from what an eye sees, not from parallel rays.</source>
        <translation>Licht wird aus dem gelernt, was ein Auge sieht, nicht aus parallelen Strahlen.</translation>
    </message>
    <message>
        <source>Take a camera that is not parallel.</source>
        <translation>Nehmen Sie eine Kamera, die nicht parallel ist.</translation>
    </message>
    <message>
        <source>The training was cancelled.</source>
        <translation>Das Training wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Finding points</source>
        <translation>Punkte werden gesucht</translation>
    </message>
    <message>
        <source>There is nothing to be seen.</source>
        <translation>Es ist nichts zu sehen.</translation>
    </message>
    <message>
        <source>Choose a preset that shows something of the series.</source>
        <translation>Wählen Sie eine Voreinstellung, die etwas von der Serie zeigt.</translation>
    </message>
    <message>
        <source>The state of the peripheral model is damaged: its parts do not belong together.</source>
        <translation>Der Zustand des peripheren Modells ist beschädigt: seine Teile gehören nicht zusammen.</translation>
    </message>
    <message>
        <source>Load it again, or have it learnt anew.</source>
        <translation>Laden Sie es noch einmal, oder lassen Sie es neu lernen.</translation>
    </message>
    <message>
        <source>Finding outlines</source>
        <translation>Umrisse werden gesucht</translation>
    </message>
    <message>
        <source>The folder for pictures cannot be made.</source>
        <translation>Der Ordner für Bilder kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>Check the path and the permissions.</source>
        <translation>Prüfen Sie den Pfad und die Zugriffsrechte.</translation>
    </message>
    <message>
        <source>Lighting views</source>
        <translation>Ansichten werden beleuchtet</translation>
    </message>
    <message>
        <source>Splats learn from what an eye sees, not from parallel rays.</source>
        <translation>Splats lernen aus dem, was ein Auge sieht, nicht aus parallelen Strahlen.</translation>
    </message>
    <message>
        <source>The samples of what is compared with cannot be halved.</source>
        <translation>Die Abtastungen des Vergleichsbildes können nicht halbiert werden.</translation>
    </message>
    <message>
        <source>Give an even number of them.</source>
        <translation>Geben Sie eine gerade Zahl davon an.</translation>
    </message>
    <message>
        <source>Tracing what is compared with</source>
        <translation>Das Vergleichsbild wird verfolgt</translation>
    </message>
    <message>
        <source>Tracing views</source>
        <translation>Ansichten werden verfolgt</translation>
    </message>
    <message>
        <source>This device runs too few threads together to train models.</source>
        <translation>Dieses Gerät lässt zu wenige Threads zusammen laufen, um Modelle zu trainieren.</translation>
    </message>
    <message>
        <source>Choose another device: `macula devices` lists them.</source>
        <translation>Wählen Sie ein anderes Gerät: `macula devices` zählt sie auf.</translation>
    </message>
    <message>
        <source>A picture of {} x {} pixels cannot be made.</source>
        <translation>Ein Bild von {} x {} Pixeln kann nicht gemacht werden.</translation>
    </message>
    <message>
        <source>Choose a size from 1 to {} on each side.</source>
        <translation>Wählen Sie eine Größe von 1 bis {} je Seite.</translation>
    </message>
    <message>
        <source>The camera&apos;s near plane is not usable.</source>
        <translation>Die nahe Ebene der Kamera ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose a distance from 0.001 to 1000000 mm.</source>
        <translation>Wählen Sie einen Abstand von 0.001 bis 1000000 mm.</translation>
    </message>
    <message>
        <source>The camera&apos;s orientation is not a rotation.</source>
        <translation>Die Ausrichtung der Kamera ist keine Drehung.</translation>
    </message>
    <message>
        <source>Give three perpendicular unit axes that are not mirrored.</source>
        <translation>Geben Sie drei senkrechte Einheitsachsen an, die nicht gespiegelt sind.</translation>
    </message>
    <message>
        <source>The camera&apos;s position is not usable.</source>
        <translation>Der Ort der Kamera ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give a position within 1000 km of the model.</source>
        <translation>Geben Sie einen Ort innerhalb von 1000 km um das Modell an.</translation>
    </message>
    <message>
        <source>The camera&apos;s focal length is not usable.</source>
        <translation>Die Brennweite der Kamera ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose 0.01 to 100000000 pixels.</source>
        <translation>Wählen Sie 0.01 bis 100000000 Pixel.</translation>
    </message>
    <message>
        <source>The camera&apos;s principal point is not usable.</source>
        <translation>Der Hauptpunkt der Kamera ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose a point within 1000000 pixels of the picture.</source>
        <translation>Wählen Sie einen Punkt innerhalb von 1000000 Pixeln um das Bild.</translation>
    </message>
    <message>
        <source>The way in which splats blend is not usable.</source>
        <translation>Die Art, wie sich Splats mischen, ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose a low-pass of 0.01 to 100 square pixels, the least of it no more, a most opaque splat of 0.01 to 0.9999, a faintest of 1e-9 to 0.009, a fringe of 1.1 to 1000000, and a least transmittance of 0 to 0.1.</source>
        <translation>Wählen Sie einen Tiefpass von 0.01 bis 100 Quadratpixeln, den kleinsten davon nicht größer, ein deckendstes Splat von 0.01 bis 0.9999, ein schwächstes von 1e-9 bis 0.009, einen Rand von 1.1 bis 1000000 und eine kleinste Durchlässigkeit von 0 bis 0.1.</translation>
    </message>
    <message>
        <source>A picture of {} x {} pixels is too large for this device.</source>
        <translation>Ein Bild von {} x {} Pixeln ist zu groß für dieses Gerät.</translation>
    </message>
    <message>
        <source>Choose one of at most {:.1f} million pixels.</source>
        <translation>Wählen Sie eines mit höchstens {:.1f} Millionen Pixeln.</translation>
    </message>
    <message>
        <source>The splats of this model are too large and too many for this device.</source>
        <translation>Die Splats dieses Modells sind zu groß und zu viele für dieses Gerät.</translation>
    </message>
    <message>
        <source>Draw a smaller picture, or a model of fewer splats.</source>
        <translation>Zeichnen Sie ein kleineres Bild oder ein Modell mit weniger Splats.</translation>
    </message>
    <message>
        <source>There is no memory for the model.</source>
        <translation>Für das Modell ist kein Speicher da.</translation>
    </message>
    <message>
        <source>The model is damaged or cut off.</source>
        <translation>Das Modell ist beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>Copy it again, or train it again.</source>
        <translation>Kopieren oder trainieren Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The model is a .macula file of version {}; this Macula reads version {}.</source>
        <translation>Das Modell ist eine .macula-Datei der Version {}; dieses Macula liest Version {}.</translation>
    </message>
    <message>
        <source>There is no memory to pack or unpack the model.</source>
        <translation>Es ist kein Speicher da, um das Modell zu packen oder auszupacken.</translation>
    </message>
    <message>
        <source>The model is too large for a glTF file.</source>
        <translation>Das Modell ist für eine glTF-Datei zu groß.</translation>
    </message>
    <message>
        <source>Write it as .ply instead.</source>
        <translation>Speichern Sie es stattdessen als .ply.</translation>
    </message>
    <message>
        <source>The model holds no splats.</source>
        <translation>Das Modell enthält keine Splats.</translation>
    </message>
    <message>
        <source>Train it again.</source>
        <translation>Trainieren Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Export the model again from where it came.</source>
        <translation>Exportieren Sie das Modell noch einmal von dort, woher es kam.</translation>
    </message>
    <message>
        <source>The glTF file is damaged or cut off.</source>
        <translation>Die glTF-Datei ist beschädigt oder abgeschnitten.</translation>
    </message>
    <message>
        <source>The glTF file is not of version 2.</source>
        <translation>Die glTF-Datei ist nicht von Version 2.</translation>
    </message>
    <message>
        <source>Export it as binary glTF 2.0.</source>
        <translation>Exportieren Sie es als binäres glTF 2.0.</translation>
    </message>
    <message>
        <source>The glTF file holds far more than a model.</source>
        <translation>Die glTF-Datei enthält weit mehr als ein Modell.</translation>
    </message>
    <message>
        <source>Export the model alone.</source>
        <translation>Exportieren Sie das Modell allein.</translation>
    </message>
    <message>
        <source>The glTF file holds no Gaussians.</source>
        <translation>Die glTF-Datei enthält keine Gaußverteilungen.</translation>
    </message>
    <message>
        <source>Choose one with the extension KHR_gaussian_splatting.</source>
        <translation>Wählen Sie eine mit der Erweiterung KHR_gaussian_splatting.</translation>
    </message>
    <message>
        <source>The Gaussians of the glTF file are of another kind than ellipses.</source>
        <translation>Die Gaußverteilungen der glTF-Datei sind von anderer Art als Ellipsen.</translation>
    </message>
    <message>
        <source>The glTF file has colours in linear light of a display, which cannot be drawn.</source>
        <translation>Die glTF-Datei hat Farben im linearen Licht eines Bildschirms, die nicht gezeichnet werden können.</translation>
    </message>
    <message>
        <source>Export it with colours in sRGB.</source>
        <translation>Exportieren Sie sie mit Farben in sRGB.</translation>
    </message>
    <message>
        <source>The Gaussians of the glTF file are packed in a way that is not known.</source>
        <translation>Die Gaußverteilungen der glTF-Datei sind auf unbekannte Weise gepackt.</translation>
    </message>
    <message>
        <source>Export it without compression, or as PLY or SPZ.</source>
        <translation>Exportieren Sie sie ohne Kompression, oder als PLY oder SPZ.</translation>
    </message>
    <message>
        <source>The Gaussians are not in the glTF file itself.</source>
        <translation>Die Gaußverteilungen sind nicht in der glTF-Datei selbst.</translation>
    </message>
    <message>
        <source>Export it as one binary file (.glb), without compression.</source>
        <translation>Exportieren Sie sie als eine binäre Datei (.glb), ohne Kompression.</translation>
    </message>
    <message>
        <source>Export it again.</source>
        <translation>Exportieren Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The glTF file lacks the attribute {} of some Gaussians.</source>
        <translation>Der glTF-Datei fehlt das Attribut {} mancher Gaußverteilungen.</translation>
    </message>
    <message>
        <source>The model cannot be read.</source>
        <translation>Das Modell kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file is larger than any {} model.</source>
        <translation>Die Datei ist größer als jedes {}-Modell.</translation>
    </message>
    <message>
        <source>That is a folder, not a model.</source>
        <translation>Das ist ein Ordner, kein Modell.</translation>
    </message>
    <message>
        <source>The model does not exist.</source>
        <translation>Das Modell gibt es nicht.</translation>
    </message>
    <message>
        <source>Choose a model of Gaussians, or convert it to PLY.</source>
        <translation>Wählen Sie ein Modell aus Gaußverteilungen, oder wandeln Sie es in PLY um.</translation>
    </message>
    <message>
        <source>Give the file one of these extensions.</source>
        <translation>Geben Sie der Datei eine dieser Endungen.</translation>
    </message>
    <message>
        <source>Export or train it again.</source>
        <translation>Exportieren oder trainieren Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The model is one of Macula&apos;s, but what it says about its {} is not understood.</source>
        <translation>Das Modell ist von Macula, aber seine Angabe ({}) ist nicht zu verstehen.</translation>
    </message>
    <message>
        <source>It is damaged or of a later version: export it again, or use a newer Macula.</source>
        <translation>Es ist beschädigt oder von einer späteren Version: exportieren Sie es noch einmal, oder verwenden Sie ein neueres Macula.</translation>
    </message>
    <message>
        <source>version</source>
        <translation>Version</translation>
    </message>
    <message>
        <source>axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>low-pass</source>
        <translation>Tiefpass</translation>
    </message>
    <message>
        <source>What the file says about the settings of its training is not understood.</source>
        <translation>Was die Datei über die Einstellungen ihres Trainings sagt, ist nicht zu verstehen.</translation>
    </message>
    <message>
        <source>It is damaged or of another version: go on with the Macula it was begun with, or train anew.</source>
        <translation>Sie ist beschädigt oder von einer anderen Version: machen Sie mit dem Macula weiter, mit dem es begonnen wurde, oder trainieren Sie neu.</translation>
    </message>
    <message>
        <source>The PLY file is cut off or damaged at splat {} of {}.</source>
        <translation>Die PLY-Datei ist bei Splat {} von {} abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>The PLY file is cut off: its header counts {} {}, for which it is too small.</source>
        <translation>Die PLY-Datei ist abgeschnitten: ihr Kopf zählt {} {}, und dafür ist sie zu klein.</translation>
    </message>
    <message>
        <source>The PLY file is cut off or damaged.</source>
        <translation>Die PLY-Datei ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>The model does not fit into memory.</source>
        <translation>Das Modell passt nicht in den Speicher.</translation>
    </message>
    <message>
        <source>Close other programs, or export a smaller one.</source>
        <translation>Schließen Sie andere Programme, oder exportieren Sie ein kleineres.</translation>
    </message>
    <message>
        <source>The PLY file holds no points.</source>
        <translation>Die PLY-Datei enthält keine Punkte.</translation>
    </message>
    <message>
        <source>Choose a model of Gaussians.</source>
        <translation>Wählen Sie ein Modell aus Gaußverteilungen.</translation>
    </message>
    <message>
        <source>The header of the PLY file {}.</source>
        <translation>Der Kopf der PLY-Datei {}.</translation>
    </message>
    <message>
        <source>The file is no PLY.</source>
        <translation>Die Datei ist kein PLY.</translation>
    </message>
    <message>
        <source>is longer than that of any model</source>
        <translation>ist länger als der jedes Modells</translation>
    </message>
    <message>
        <source>is cut off</source>
        <translation>ist abgeschnitten</translation>
    </message>
    <message>
        <source>names a version that is not 1.0</source>
        <translation>nennt eine Version, die nicht 1.0 ist</translation>
    </message>
    <message>
        <source>names an unknown format</source>
        <translation>nennt ein unbekanntes Format</translation>
    </message>
    <message>
        <source>counts fewer elements than none</source>
        <translation>zählt weniger Elemente als keines</translation>
    </message>
    <message>
        <source>does not say how many elements there are</source>
        <translation>sagt nicht, wie viele Elemente es gibt</translation>
    </message>
    <message>
        <source>has a list whose length is no whole number</source>
        <translation>hat eine Liste, deren Länge keine ganze Zahl ist</translation>
    </message>
    <message>
        <source>names an unknown type of number</source>
        <translation>nennt eine unbekannte Art von Zahl</translation>
    </message>
    <message>
        <source>has a property without a name</source>
        <translation>hat eine Eigenschaft ohne Namen</translation>
    </message>
    <message>
        <source>has a line that is none of a PLY</source>
        <translation>hat eine Zeile, die keine eines PLY ist</translation>
    </message>
    <message>
        <source>does not name a format</source>
        <translation>nennt kein Format</translation>
    </message>
    <message>
        <source>The PLY file has a list in the place of {}.</source>
        <translation>Die PLY-Datei hat eine Liste anstelle von {}.</translation>
    </message>
    <message>
        <source>The PLY file has {} twice.</source>
        <translation>Die PLY-Datei hat {} zweimal.</translation>
    </message>
    <message>
        <source>The PLY file is no model of Gaussians: it lacks {}.</source>
        <translation>Die PLY-Datei ist kein Modell aus Gaußverteilungen: ihr fehlt {}.</translation>
    </message>
    <message>
        <source>Choose a model as 3D Gaussian splatting writes it, not a mesh or a point cloud.</source>
        <translation>Wählen Sie ein Modell, wie es 3D Gaussian Splatting schreibt, kein Netz und keine Punktwolke.</translation>
    </message>
    <message>
        <source>The PLY file has {} coefficients of colour f_rest; 0, 9, 24 or 45 without a gap are understood.</source>
        <translation>Die PLY-Datei hat {} Farbkoeffizienten f_rest; verstanden werden 0, 9, 24 oder 45 ohne Lücke.</translation>
    </message>
    <message>
        <source>Export it with spherical harmonics of degree 3 or less.</source>
        <translation>Exportieren Sie es mit Kugelflächenfunktionen vom Grad 3 oder weniger.</translation>
    </message>
    <message>
        <source>The SPZ file is cut off or damaged.</source>
        <translation>Die SPZ-Datei ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>The model reaches farther than an SPZ file can say: 8 km from its origin.</source>
        <translation>Das Modell reicht weiter, als eine SPZ-Datei angeben kann: 8 km von seinem Ursprung.</translation>
    </message>
    <message>
        <source>Remove the splats that are so far away, or write a PLY.</source>
        <translation>Entfernen Sie die Splats, die so weit weg sind, oder speichern Sie eine PLY.</translation>
    </message>
    <message>
        <source>The file is gzip, but no SPZ model is in it.</source>
        <translation>Die Datei ist gzip, aber kein SPZ-Modell ist darin.</translation>
    </message>
    <message>
        <source>The SPZ file has version {}; 1 to {} are read.</source>
        <translation>Die SPZ-Datei hat Version {}; gelesen werden 1 bis {}.</translation>
    </message>
    <message>
        <source>Convert it to version 4, or to PLY.</source>
        <translation>Wandeln Sie sie in Version 4 oder in PLY um.</translation>
    </message>
    <message>
        <source>The SPZ file has spherical harmonics of degree {}; 0 to {} are read.</source>
        <translation>Die SPZ-Datei hat Kugelflächenfunktionen vom Grad {}; gelesen werden 0 bis {}.</translation>
    </message>
    <message>
        <source>Export it with a lower degree.</source>
        <translation>Exportieren Sie sie mit einem kleineren Grad.</translation>
    </message>
    <message>
        <source>The SPZ file counts {} splats; no more than {} are read.</source>
        <translation>Die SPZ-Datei zählt {} Splats; mehr als {} werden nicht gelesen.</translation>
    </message>
    <message>
        <source>Convert it to PLY, of which there is no such limit.</source>
        <translation>Wandeln Sie sie in PLY um, das keine solche Grenze hat.</translation>
    </message>
    <message>
        <source>The SPZ file counts {} splats, for which it is too small.</source>
        <translation>Die SPZ-Datei zählt {} Splats, und dafür ist sie zu klein.</translation>
    </message>
    <message>
        <source>The model has {} splats; an SPZ file holds at most {}.</source>
        <translation>Das Modell hat {} Splats; eine SPZ-Datei fasst höchstens {}.</translation>
    </message>
    <message>
        <source>Write a PLY.</source>
        <translation>Speichern Sie eine PLY.</translation>
    </message>
    <message>
        <source>The model&apos;s splats are so much alike that its SPZ file could not be told from a false one.</source>
        <translation>Die Splats des Modells sind einander so ähnlich, dass seine SPZ-Datei nicht von einer falschen zu unterscheiden wäre.</translation>
    </message>
    <message>
        <source>The file is larger than any SPZ model.</source>
        <translation>Die Datei ist größer als jedes SPZ-Modell.</translation>
    </message>
    <message>
        <source>The SPZ file names axes (number {}) that this version does not know.</source>
        <translation>Die SPZ-Datei nennt Achsen (Nummer {}), die diese Version nicht kennt.</translation>
    </message>
    <message>
        <source>Convert it to one with the axes of the format (right, up, back), or to PLY.</source>
        <translation>Wandeln Sie sie in eine mit den Achsen des Formats um (rechts, oben, hinten), oder in PLY.</translation>
    </message>
    <message>
        <source>The file holds no training that could go on.</source>
        <translation>Die Datei enthält kein Training, das weitergehen könnte.</translation>
    </message>
    <message>
        <source>Choose a .macula file, or train anew: PLY and SPZ hold only the model.</source>
        <translation>Wählen Sie eine .macula-Datei, oder trainieren Sie neu: PLY und SPZ enthalten nur das Modell.</translation>
    </message>
    <message>
        <source>The model has spherical harmonics of degree {}; 0 to {} are supported.</source>
        <translation>Das Modell hat Kugelflächenfunktionen vom Grad {}; unterstützt werden 0 bis {}.</translation>
    </message>
    <message>
        <source>The model is damaged: it does not have the same number of entries for all properties.</source>
        <translation>Das Modell ist beschädigt: es hat nicht für alle Eigenschaften gleich viele Einträge.</translation>
    </message>
    <message>
        <source>Load or train it again.</source>
        <translation>Laden oder trainieren Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The model&apos;s place in the patient is not a number.</source>
        <translation>Die Lage des Modells im Patienten ist keine Zahl.</translation>
    </message>
    <message>
        <source>{} of the {} splats of the model hold values that are not numbers.</source>
        <translation>{} der {} Splats des Modells enthalten Werte, die keine Zahlen sind.</translation>
    </message>
    <message>
        <source>The settings of the training make no sense.</source>
        <translation>Die Einstellungen des Trainings ergeben keinen Sinn.</translation>
    </message>
    <message>
        <source>Position rates and decays must be above 0, other rates not below 0, both betas from 0 to below 1, and epsilon from 1e-30 to 1.</source>
        <translation>Raten der Position und Abklingwerte müssen über 0 liegen, andere Raten nicht unter 0, beide Betas von 0 bis unter 1 und Epsilon von 1e-30 bis 1.</translation>
    </message>
    <message>
        <source>The state of the training does not fit the model.</source>
        <translation>Der Zustand des Trainings passt nicht zum Modell.</translation>
    </message>
    <message>
        <source>It was saved for another model, or is damaged: train anew.</source>
        <translation>Er wurde für ein anderes Modell gespeichert oder ist beschädigt: trainieren Sie neu.</translation>
    </message>
    <message>
        <source>A picture to learn from is empty or not of its view&apos;s size.</source>
        <translation>Ein Bild, aus dem gelernt werden soll, ist leer oder hat nicht die Größe seiner Ansicht.</translation>
    </message>
    <message>
        <source>Make it again.</source>
        <translation>Machen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Pictures are halved 0 to 15 times, the weight of D-SSIM and the shares of splats are 0 to 1, the exposure and the steps between density control above 0.</source>
        <translation>Bilder werden 0- bis 15-mal halbiert, das Gewicht von D-SSIM und die Anteile der Splats sind 0 bis 1, die Belichtung und die Schritte zwischen Anpassungen der Dichte über 0.</translation>
    </message>
    <message>
        <source>Models of this degree of colour can be shown, but not trained.</source>
        <translation>Modelle mit diesem Grad der Farbe können gezeigt, aber nicht trainiert werden.</translation>
    </message>
    <message>
        <source>Reduce the model to degree 1.</source>
        <translation>Verringern Sie das Modell auf Grad 1.</translation>
    </message>
    <message>
        <source>There is no picture to learn from.</source>
        <translation>Es gibt kein Bild, aus dem zu lernen wäre.</translation>
    </message>
    <message>
        <source>Add views first.</source>
        <translation>Fügen Sie zuerst Ansichten hinzu.</translation>
    </message>
    <message>
        <source>The training was begun by version {} of the trainer, and would go on otherwise with version {}.</source>
        <translation>Das Training wurde mit Version {} des Trainers begonnen und ginge mit Version {} anders weiter.</translation>
    </message>
    <message>
        <source>Go on with the Macula it was begun with, or train anew; its model can still be drawn.</source>
        <translation>Machen Sie mit dem Macula weiter, mit dem es begonnen wurde, oder trainieren Sie neu; das Modell kann noch gezeichnet werden.</translation>
    </message>
    <message>
        <source>The state of the training is damaged: its parts do not belong together.</source>
        <translation>Der Zustand des Trainings ist beschädigt: seine Teile gehören nicht zusammen.</translation>
    </message>
    <message>
        <source>Load it again, or train anew.</source>
        <translation>Laden Sie ihn noch einmal, oder trainieren Sie neu.</translation>
    </message>
    <message>
        <source>There is nothing to trace yet.</source>
        <translation>Es gibt noch nichts zu verfolgen.</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>A volume of more than 2147 million voxels cannot be masked.</source>
        <translation>In einem Volumen von mehr als 2147 Millionen Voxeln kann nichts ausgeblendet werden.</translation>
    </message>
    <message>
        <source>Show it without a mask.</source>
        <translation>Zeigen Sie es, ohne etwas auszublenden.</translation>
    </message>
    <message>
        <source>A volume of {} million voxels is more than can be traced.</source>
        <translation>Ein Volumen von {} Millionen Voxeln ist mehr, als verfolgt werden kann.</translation>
    </message>
    <message>
        <source>Open a smaller series.</source>
        <translation>Öffnen Sie eine kleinere Serie.</translation>
    </message>
    <message>
        <source>Choose another environment, or a built-in light rig.</source>
        <translation>Wählen Sie eine andere Umgebung oder eine eingebaute Beleuchtung.</translation>
    </message>
    <message>
        <source>Projections show all of the volume.</source>
        <translation>Projektionen zeigen das ganze Volumen.</translation>
    </message>
    <message>
        <source>Choose another look.</source>
        <translation>Wählen Sie eine andere Darstellung.</translation>
    </message>
    <message>
        <source>The search for points on the surface was cancelled.</source>
        <translation>Die Suche nach Punkten auf der Oberfläche wurde abgebrochen.</translation>
    </message>
    <message>
        <source>This look traces no paths.</source>
        <translation>Diese Darstellung verfolgt keine Pfade.</translation>
    </message>
    <message>
        <source>Choose the cinematic look.</source>
        <translation>Wählen Sie die Darstellung Cinematic.</translation>
    </message>
    <message>
        <source>Choose a number from 0 to {} mm.</source>
        <translation>Wählen Sie eine Zahl von 0 bis {} mm.</translation>
    </message>
    <message>
        <source>Choose a number above 0, up to {} mm.</source>
        <translation>Wählen Sie eine Zahl über 0, bis {} mm.</translation>
    </message>
    <message>
        <source>A parallel view has no fovea.</source>
        <translation>Eine parallele Ansicht hat keine Fovea.</translation>
    </message>
    <message>
        <source>Trace all of the picture.</source>
        <translation>Verfolgen Sie das ganze Bild.</translation>
    </message>
    <message>
        <source>The foveation is not usable.</source>
        <translation>Die Foveation ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give a gaze inside the picture, a field above 0 and below 170 degrees, and 1 to 16 times.</source>
        <translation>Geben Sie einen Blick innerhalb des Bildes, ein Feld über 0 und unter 170 Grad und 1- bis 16-fach an.</translation>
    </message>
    <message>
        <source>This number of points on the surface makes no sense.</source>
        <translation>Diese Zahl von Punkten auf der Oberfläche ergibt keinen Sinn.</translation>
    </message>
    <message>
        <source>There is no second volume with a preset.</source>
        <translation>Es gibt kein zweites Volumen mit einer Voreinstellung.</translation>
    </message>
    <message>
        <source>Open a second volume, and choose a preset for it.</source>
        <translation>Öffnen Sie ein zweites Volumen, und wählen Sie eine Voreinstellung dafür.</translation>
    </message>
    <message>
        <source>Where the second volume lies is not usable.</source>
        <translation>Wo das zweite Volumen liegt, ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Register the two volumes again.</source>
        <translation>Registrieren Sie die beiden Volumen noch einmal.</translation>
    </message>
    <message>
        <source>The coloured segments are not of this volume.</source>
        <translation>Die farbigen Segmente gehören nicht zu diesem Volumen.</translation>
    </message>
    <message>
        <source>Show the segmentation again.</source>
        <translation>Zeigen Sie die Segmentierung noch einmal.</translation>
    </message>
    <message>
        <source>A coloured segment has no colour.</source>
        <translation>Ein farbiges Segment hat keine Farbe.</translation>
    </message>
    <message>
        <source>The colour of a segment is not usable.</source>
        <translation>Die Farbe eines Segments ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give red, green, blue and opacity from 0 to 1.</source>
        <translation>Geben Sie Rot, Grün, Blau und Deckkraft von 0 bis 1 an.</translation>
    </message>
    <message>
        <source>The clip is not usable: {}.</source>
        <translation>Der Beschnitt ist nicht brauchbar: {}.</translation>
    </message>
    <message>
        <source>Correct the preset.</source>
        <translation>Berichtigen Sie die Voreinstellung.</translation>
    </message>
    <message>
        <source>The preset has no range of values that could be fitted.</source>
        <translation>Die Voreinstellung hat keinen Wertebereich, der angepasst werden könnte.</translation>
    </message>
    <message>
        <source>Use it without fitting, or give it an effectiveRange.</source>
        <translation>Verwenden Sie sie ohne Anpassung, oder geben Sie ihr einen effectiveRange.</translation>
    </message>
    <message>
        <source>Choose a built-in opacity table, or a 16-bit CLUT, and save the preset again.</source>
        <translation>Wählen Sie eine eingebaute Deckkrafttabelle oder eine CLUT mit 16 Bit, und speichern Sie die Voreinstellung noch einmal.</translation>
    </message>
    <message>
        <source>The filters of the preset are not applied.</source>
        <translation>Die Filter der Voreinstellung werden nicht angewendet.</translation>
    </message>
    <message>
        <source>A point of {} has no usable {}.</source>
        <translation>Ein Punkt von {} hat kein brauchbares {}.</translation>
    </message>
    <message>
        <source>Give it a number from {:g} to {:g}.</source>
        <translation>Geben Sie ihm eine Zahl von {:g} bis {:g}.</translation>
    </message>
    <message>
        <source>The {} of the transfer function has {} points.</source>
        <translation>{} der Übertragungsfunktion hat {} Punkte.</translation>
    </message>
    <message>
        <source>Give it 1 to {} points.</source>
        <translation>Geben Sie ihr 1 bis {} Punkte.</translation>
    </message>
    <message>
        <source>The version of the MITK transfer function is not known.</source>
        <translation>Die Version der MITK-Übertragungsfunktion ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Only version 1 can be read.</source>
        <translation>Nur Version 1 kann gelesen werden.</translation>
    </message>
    <message>
        <source>Opacities or colours outside 0 to 1 were clamped.</source>
        <translation>Deckkräfte oder Farben außerhalb von 0 bis 1 wurden begrenzt.</translation>
    </message>
    <message>
        <source>The colour map has no opacities; a ramp from 0 at its first to 1 at its last colour was taken.</source>
        <translation>Die Farbtabelle hat keine Deckkräfte; eine Rampe von 0 bei der ersten bis 1 bei der letzten Farbe wurde genommen.</translation>
    </message>
    <message>
        <source>Only the first volume property, and its first component, are used.</source>
        <translation>Nur die erste Volumeneigenschaft und ihre erste Komponente werden verwendet.</translation>
    </message>
    <message>
        <source>Put the table beside the preset as NAME.plist, or save a 16-bit CLUT with the preset.</source>
        <translation>Legen Sie die Tabelle als NAME.plist neben die Voreinstellung, oder speichern Sie eine CLUT mit 16 Bit darin.</translation>
    </message>
    <message>
        <source>Give a JSON preset, a .vp or presets.xml of 3D Slicer, a ParaView or VolView JSON, an XML of MITK, or a plist of Horos.</source>
        <translation>Wählen Sie eine JSON-Voreinstellung, eine .vp oder presets.xml von 3D Slicer, ein JSON von ParaView oder VolView, ein XML von MITK oder eine plist von Horos.</translation>
    </message>
    <message>
        <source>The file holds {} presets.</source>
        <translation>Die Datei enthält {} Voreinstellungen.</translation>
    </message>
    <message>
        <source>holds a number that cannot be read</source>
        <translation>enthält eine Zahl, die nicht gelesen werden kann</translation>
    </message>
    <message>
        <source>has a key without a value, or a value without a key</source>
        <translation>hat einen Schlüssel ohne Wert oder einen Wert ohne Schlüssel</translation>
    </message>
    <message>
        <source>Check that it is complete.</source>
        <translation>Prüfen Sie, ob sie vollständig ist.</translation>
    </message>
    <message>
        <source>The property list is in its binary form.</source>
        <translation>Die Property List ist in ihrer binären Form.</translation>
    </message>
    <message>
        <source>Convert it on a Mac: plutil -convert xml1 FILE.</source>
        <translation>Wandeln Sie sie auf einem Mac um: plutil -convert xml1 DATEI.</translation>
    </message>
    <message>
        <source>The file is no property list.</source>
        <translation>Die Datei ist keine Property List.</translation>
    </message>
    <message>
        <source>A .vp file of 3D Slicer has {} lines; this has {}.</source>
        <translation>Eine .vp-Datei von 3D Slicer hat {} Zeilen; diese hat {}.</translation>
    </message>
    <message>
        <source>Line {} is not as expected.</source>
        <translation>Zeile {} ist nicht wie erwartet.</translation>
    </message>
    <message>
        <source>Expected {}.</source>
        <translation>Erwartet: {}.</translation>
    </message>
    <message>
        <source>The {} of the preset {} is no number from 0 to {:g}.</source>
        <translation>{} der Voreinstellung {} ist keine Zahl von 0 bis {:g}.</translation>
    </message>
    <message>
        <source>Correct it, or remove it.</source>
        <translation>Berichtigen oder entfernen Sie das.</translation>
    </message>
    <message>
        <source>Use 0 for nearest or 1 for linear.</source>
        <translation>Nehmen Sie 0 für nächste oder 1 für linear.</translation>
    </message>
    <message>
        <source>The file holds too many presets.</source>
        <translation>Die Datei enthält zu viele Voreinstellungen.</translation>
    </message>
    <message>
        <source>Split it into files of at most {}.</source>
        <translation>Teilen Sie sie in Dateien mit höchstens {}.</translation>
    </message>
    <message>
        <source>The file holds no volume property of 3D Slicer.</source>
        <translation>Die Datei enthält keine Volumeneigenschaft von 3D Slicer.</translation>
    </message>
    <message>
        <source>Give a presets.xml, or an MRML scene with volume rendering.</source>
        <translation>Wählen Sie eine presets.xml oder eine MRML-Szene mit Volumen-Rendering.</translation>
    </message>
    <message>
        <source>The {} of the preset {}.</source>
        <translation>{} der Voreinstellung {}.</translation>
    </message>
    <message>
        <source>Save the preset again in the program that it comes from.</source>
        <translation>Speichern Sie die Voreinstellung noch einmal in dem Programm, aus dem sie kommt.</translation>
    </message>
    <message>
        <source>Registration was cancelled.</source>
        <translation>Die Registrierung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Link the volumes by hand, or choose another series.</source>
        <translation>Koppeln Sie die Volumen von Hand, oder wählen Sie eine andere Serie.</translation>
    </message>
    <message>
        <source>Registering the second volume</source>
        <translation>Das zweite Volumen wird registriert</translation>
    </message>
    <message>
        <source>There is not enough memory to register the volumes.</source>
        <translation>Es ist nicht genug Speicher da, um die Volumen zu registrieren.</translation>
    </message>
    <message>
        <source>Close other programs, or link the volumes by hand.</source>
        <translation>Schließen Sie andere Programme, oder koppeln Sie die Volumen von Hand.</translation>
    </message>
    <message>
        <source>Camera {} of the path is none: {}</source>
        <translation>Kamera {} der Fahrt ist keine: {}</translation>
    </message>
    <message>
        <source>This model was made elsewhere and does not say where the patient&apos;s left or front is.</source>
        <translation>Dieses Modell wurde anderswo erstellt und sagt nicht, wo links oder vorn am Patienten ist.</translation>
    </message>
    <message>
        <source>Give --camera or --cameras, or none of these to look along its own +z.</source>
        <translation>Geben Sie --camera oder --cameras an, oder keines davon, um entlang seiner eigenen Achse +z zu blicken.</translation>
    </message>
    <message>
        <source>The file is no list of cameras.</source>
        <translation>Die Datei ist keine Liste von Kameras.</translation>
    </message>
    <message>
        <source>Give --cameras the cameras.json that was written beside the model; --camera takes one of Macula&apos;s own.</source>
        <translation>Geben Sie mit --cameras die cameras.json an, die neben dem Modell geschrieben wurde; --camera nimmt eine von Macula.</translation>
    </message>
    <message>
        <source>The file holds a list, not one camera of Macula&apos;s own.</source>
        <translation>Die Datei enthält eine Liste, nicht eine einzelne Kamera von Macula.</translation>
    </message>
    <message>
        <source>Give it as --cameras.</source>
        <translation>Geben Sie sie als --cameras an.</translation>
    </message>
    <message>
        <source>The file holds no cameras.</source>
        <translation>Die Datei enthält keine Kameras.</translation>
    </message>
    <message>
        <source>Check that it is the cameras.json of this model.</source>
        <translation>Prüfen Sie, ob es die cameras.json dieses Modells ist.</translation>
    </message>
    <message>
        <source>The picture holds display colours, not light.</source>
        <translation>Das Bild enthält Anzeigefarben, kein Licht.</translation>
    </message>
    <message>
        <source>Give a Radiance HDR or OpenEXR picture.</source>
        <translation>Geben Sie ein Bild in Radiance HDR oder OpenEXR an.</translation>
    </message>
    <message>
        <source>The picture is {} by {} pixels, not twice as wide as high.</source>
        <translation>Das Bild hat {} mal {} Pixel und ist nicht doppelt so breit wie hoch.</translation>
    </message>
    <message>
        <source>Give an equirectangular panorama.</source>
        <translation>Geben Sie ein equirektangulares Panorama an.</translation>
    </message>
    <message>
        <source>The picture holds {} values that are not finite and {} negative ones.</source>
        <translation>Das Bild enthält {} Werte, die nicht endlich sind, und {} negative.</translation>
    </message>
    <message>
        <source>Repair it, or give another one.</source>
        <translation>Reparieren Sie es, oder geben Sie ein anderes an.</translation>
    </message>
    <message>
        <source>There are no such lights.</source>
        <translation>Diese Beleuchtung gibt es nicht.</translation>
    </message>
    <message>
        <source>A picture is no rig of lights.</source>
        <translation>Ein Bild ist keine Beleuchtung aus einzelnen Lichtern.</translation>
    </message>
    <message>
        <source>Choose lights by name, or those of a JSON file.</source>
        <translation>Wählen Sie eine Beleuchtung nach ihrem Namen oder die einer JSON-Datei.</translation>
    </message>
    <message>
        <source>These lights hang on the camera.</source>
        <translation>Diese Beleuchtung hängt an der Kamera.</translation>
    </message>
    <message>
        <source>A peripheral model holds light that stays where it is: choose lights of the patient.</source>
        <translation>Ein peripheres Modell enthält Licht, das an seinem Ort bleibt: wählen Sie eine Beleuchtung des Patienten.</translation>
    </message>
    <message>
        <source>There is no such preset.</source>
        <translation>Diese Voreinstellung gibt es nicht.</translation>
    </message>
    <message>
        <source>The size of the picture is not usable.</source>
        <translation>Die Größe des Bildes ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give --size as WIDTHxHEIGHT in pixels, each from 1 to {}.</source>
        <translation>Geben Sie --size als BREITExHÖHE in Pixeln an, jede von 1 bis {}.</translation>
    </message>
    <message>
        <source>The window is not usable.</source>
        <translation>Die Fensterung ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give --window as CENTRE,WIDTH in units of the series, the width above 0.</source>
        <translation>Geben Sie --window als MITTE,BREITE in Einheiten der Serie an, die Breite über 0.</translation>
    </message>
    <message>
        <source>The background is not usable.</source>
        <translation>Der Hintergrund ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Give --background as R,G,B, each from 0 to 1: 1,1,1 is white.</source>
        <translation>Geben Sie --background als R,G,B an, jedes von 0 bis 1: 1,1,1 ist Weiß.</translation>
    </message>
    <message>
        <source>That part of the clip is not there any more.</source>
        <translation>Diesen Teil des Beschnitts gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>Take hold of another one.</source>
        <translation>Fassen Sie einen anderen.</translation>
    </message>
    <message>
        <source>This clip cannot be kept with the study.</source>
        <translation>Dieser Beschnitt kann nicht mit der Studie behalten werden.</translation>
    </message>
    <message>
        <source>Reset the clips, and cut again.</source>
        <translation>Setzen Sie den Beschnitt zurück, und schneiden Sie noch einmal.</translation>
    </message>
    <message>
        <source>Hiding voxels</source>
        <translation>Voxel werden ausgeblendet</translation>
    </message>
    <message>
        <source>Hiding voxels was cancelled.</source>
        <translation>Das Ausblenden der Voxel wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is not enough memory to hide parts of the volume.</source>
        <translation>Es ist nicht genug Speicher da, um Teile des Volumens auszublenden.</translation>
    </message>
    <message>
        <source>Close other programs, or hide less. The picture and what is chosen stay as before.</source>
        <translation>Schließen Sie andere Programme, oder blenden Sie weniger aus. Bild und Auswahl bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>The place of the clip is not a number.</source>
        <translation>Der Ort des Beschnitts ist keine Zahl.</translation>
    </message>
    <message>
        <source>Give it in mm.</source>
        <translation>Geben Sie ihn in mm an.</translation>
    </message>
    <message>
        <source>Nothing of the volume would be left.</source>
        <translation>Vom Volumen bliebe nichts übrig.</translation>
    </message>
    <message>
        <source>Choose another place, or begin without a clip.</source>
        <translation>Wählen Sie einen anderen Ort, oder beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>A clip with a box of another kind has six planes and no more.</source>
        <translation>Ein Beschnitt mit einem anderen Quader hat sechs Ebenen und nicht mehr.</translation>
    </message>
    <message>
        <source>Open another face first, or begin without a clip.</source>
        <translation>Öffnen Sie zuerst eine andere Fläche, oder beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>Nothing is left to remove on the {} side.</source>
        <translation>Auf der Seite {} ist nichts mehr zu entfernen.</translation>
    </message>
    <message>
        <source>Move the cross-hair into what is shown.</source>
        <translation>Bewegen Sie das Fadenkreuz in das Gezeigte.</translation>
    </message>
    <message>
        <source>The slab has no thickness.</source>
        <translation>Der Slab hat keine Dicke.</translation>
    </message>
    <message>
        <source>Give it in mm, more than 0.</source>
        <translation>Geben Sie sie in mm an, größer als 0.</translation>
    </message>
    <message>
        <source>The slab would be outside of the volume.</source>
        <translation>Der Slab läge außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>Move the cross-hair into the volume.</source>
        <translation>Bewegen Sie das Fadenkreuz in das Volumen.</translation>
    </message>
    <message>
        <source>The corner would be outside of the volume.</source>
        <translation>Die Ecke läge außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>A ball of that size is not possible here.</source>
        <translation>Eine Kugel dieser Größe ist hier nicht möglich.</translation>
    </message>
    <message>
        <source>Give a radius from {:.4g} to {:.4g} mm.</source>
        <translation>Geben Sie einen Radius von {:.4g} bis {:.4g} mm an.</translation>
    </message>
    <message>
        <source>The ball would be outside of the volume.</source>
        <translation>Die Kugel läge außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>There is no clip to turn inside out.</source>
        <translation>Es gibt keinen Beschnitt zum Umkehren.</translation>
    </message>
    <message>
        <source>Choose a clip, or cut something off.</source>
        <translation>Wählen Sie einen Beschnitt, oder schneiden Sie etwas ab.</translation>
    </message>
    <message>
        <source>Only a clip of one part can be turned inside out.</source>
        <translation>Nur ein Beschnitt aus einem Teil kann umgekehrt werden.</translation>
    </message>
    <message>
        <source>This one has {}; begin without a clip.</source>
        <translation>Dieser hat {}; beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>The depth of the cut is not a number.</source>
        <translation>Die Tiefe des Schnitts ist keine Zahl.</translation>
    </message>
    <message>
        <source>The clip leaves nothing of this volume.</source>
        <translation>Der Beschnitt lässt von diesem Volumen nichts übrig.</translation>
    </message>
    <message>
        <source>Begin again without a clip.</source>
        <translation>Beginnen Sie noch einmal ohne Beschnitt.</translation>
    </message>
    <message>
        <source>Draw around what is to be removed, in one go.</source>
        <translation>Umfahren Sie in einem Zug, was entfernt werden soll.</translation>
    </message>
    <message>
        <source>Cutting with the scissors</source>
        <translation>Mit der Schere wird geschnitten</translation>
    </message>
    <message>
        <source>The cut was cancelled.</source>
        <translation>Der Schnitt wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Draw the outline around less, or keep the inside with Shift.</source>
        <translation>Umfahren Sie weniger, oder behalten Sie mit Umschalt das Innere.</translation>
    </message>
    <message>
        <source>There is not enough memory to cut this volume with the scissors.</source>
        <translation>Es ist nicht genug Speicher da, um dieses Volumen mit der Schere zu schneiden.</translation>
    </message>
    <message>
        <source>Close other programs, or clip with a box, planes or a ball.</source>
        <translation>Schließen Sie andere Programme, oder beschneiden Sie mit einem Quader, Ebenen oder einer Kugel.</translation>
    </message>
    <message>
        <source>shaded</source>
        <translation>schattiert</translation>
    </message>
    <message>
        <source>hues kept</source>
        <translation>Farbtöne erhalten</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>beschnitten</translation>
    </message>
    <message>
        <source>What may be a table is shown, as Macula cannot tell it from the patient for sure; --remove-table leaves it out.</source>
        <translation>Was ein Tisch sein kann, wird gezeigt, da Macula es nicht sicher vom Patienten unterscheiden kann; --remove-table lässt es weg.</translation>
    </message>
    <message>
        <source>--keep-table shows what was left out.</source>
        <translation>--keep-table zeigt das Weggelassene.</translation>
    </message>
    <message>
        <source>The view keeps or hides segments; here they change nothing.</source>
        <translation>Die Ansicht behält Segmente oder blendet sie aus; hier ändern sie nichts.</translation>
    </message>
    <message>
        <source>The view has segments in colour; here they have none.</source>
        <translation>Die Ansicht hat farbige Segmente; hier haben sie keine Farbe.</translation>
    </message>
    <message>
        <source>The view has a second volume in the picture; here it is left out.</source>
        <translation>Die Ansicht hat ein zweites Volumen im Bild; hier ist es weggelassen.</translation>
    </message>
    <message>
        <source>The background is no colour.</source>
        <translation>Der Hintergrund ist keine Farbe.</translation>
    </message>
    <message>
        <source>Give black, white, grey, or red, green and blue as #rrggbb: #202830 is a dark blue.</source>
        <translation>Geben Sie black, white, grey oder Rot, Grün und Blau als #rrggbb an: #202830 ist ein dunkles Blau.</translation>
    </message>
    <message>
        <source>There is no such light.</source>
        <translation>Dieses Licht gibt es nicht.</translation>
    </message>
    <message>
        <source>Choose another one of the rig.</source>
        <translation>Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>Without any light the picture would be black.</source>
        <translation>Ohne jedes Licht wäre das Bild schwarz.</translation>
    </message>
    <message>
        <source>Leave a light, or a sky that is not black.</source>
        <translation>Lassen Sie ein Licht oder einen Himmel, der nicht schwarz ist.</translation>
    </message>
    <message>
        <source>The rig has no room for one more light.</source>
        <translation>Für ein weiteres Licht ist kein Platz.</translation>
    </message>
    <message>
        <source>Remove one first.</source>
        <translation>Entfernen Sie zuerst eines.</translation>
    </message>
    <message>
        <source>Choose another presentation state.</source>
        <translation>Wählen Sie einen anderen Presentation State.</translation>
    </message>
    <message>
        <source>A presentation state refers to DICOM images with identifiers and a frame of reference, and this series has none.</source>
        <translation>Ein Presentation State bezieht sich auf DICOM-Bilder mit Kennungen und einem Koordinatensystem, und diese Serie hat keine.</translation>
    </message>
    <message>
        <source>There is no picture yet to make a presentation state of.</source>
        <translation>Es gibt noch kein Bild für einen Presentation State.</translation>
    </message>
    <message>
        <source>Wait until the study is shown.</source>
        <translation>Warten Sie, bis die Studie gezeigt wird.</translation>
    </message>
    <message>
        <source>The presentation state is of other images.</source>
        <translation>Der Presentation State ist von anderen Bildern.</translation>
    </message>
    <message>
        <source>Open the series of these images, or choose another presentation state.</source>
        <translation>Öffnen Sie die Serie dieser Bilder, oder wählen Sie einen anderen Presentation State.</translation>
    </message>
    <message>
        <source>No DICOM study is open.</source>
        <translation>Es ist keine DICOM-Studie offen.</translation>
    </message>
    <message>
        <source>Open the series of the presentation state first.</source>
        <translation>Öffnen Sie zuerst die Serie des Presentation States.</translation>
    </message>
    <message>
        <source>What a newer Macula has written cannot be read; the picture is as others show it.</source>
        <translation>Was ein neueres Macula geschrieben hat, kann nicht gelesen werden; das Bild ist, wie andere es zeigen.</translation>
    </message>
    <message>
        <source>The presentation state is of another series.</source>
        <translation>Der Presentation State ist von einer anderen Serie.</translation>
    </message>
    <message>
        <source>Open that series, or choose another presentation state.</source>
        <translation>Öffnen Sie diese Serie, oder wählen Sie einen anderen Presentation State.</translation>
    </message>
    <message>
        <source>The presentation state is of other images of this series, such as another phase.</source>
        <translation>Der Presentation State ist von anderen Bildern dieser Serie, etwa einer anderen Phase.</translation>
    </message>
    <message>
        <source>Choose the volume of these images, or another presentation state.</source>
        <translation>Wählen Sie das Volumen dieser Bilder oder einen anderen Presentation State.</translation>
    </message>
    <message>
        <source>The presentation state is of other images of this series, too, or of a part of these alone.</source>
        <translation>Der Presentation State ist auch von anderen Bildern dieser Serie oder nur von einem Teil dieser Bilder.</translation>
    </message>
    <message>
        <source>The presentation state is of the values of the images, and this PET is shown in SUV.</source>
        <translation>Der Presentation State gilt für die Werte der Bilder, und dieses PET wird in SUV gezeigt.</translation>
    </message>
    <message>
        <source>Choose a preset or a window in SUV.</source>
        <translation>Wählen Sie eine Voreinstellung oder ein Fenster in SUV.</translation>
    </message>
    <message>
        <source>What lies before or behind the depth of its view is shown, too.</source>
        <translation>Auch was vor oder hinter der Tiefe seiner Ansicht liegt, wird gezeigt.</translation>
    </message>
    <message>
        <source>Second volume: Same frame of reference, not registered: the patient may have moved.</source>
        <translation>Zweites Volumen: Gleiches Bezugssystem, nicht registriert: der Patient kann sich bewegt haben.</translation>
    </message>
    <message>
        <source>The second volume was registered, to {:.1f} mm.</source>
        <translation>Das zweite Volumen wurde registriert, auf {:.1f} mm.</translation>
    </message>
    <message>
        <source>Nothing of the second volume lies in the study.</source>
        <translation>Nichts vom zweiten Volumen liegt in der Studie.</translation>
    </message>
    <message>
        <source>Choose another series by --second-series, or register both by --registration search.</source>
        <translation>Wählen Sie mit --second-series eine andere Serie, oder registrieren Sie beide mit --registration search.</translation>
    </message>
    <message>
        <source>The view was saved with another second volume: its place and look are not those of this one.</source>
        <translation>Die Ansicht wurde mit einem anderen zweiten Volumen gespeichert: Lage und Darstellung sind nicht die von diesem.</translation>
    </message>
    <message>
        <source>The second volume is of another patient than the study.</source>
        <translation>Das zweite Volumen ist von einem anderen Patienten als die Studie.</translation>
    </message>
    <message>
        <source>Choose a series of the same patient by --second and --second-series.</source>
        <translation>Wählen Sie mit --second und --second-series eine Serie desselben Patienten.</translation>
    </message>
    <message>
        <source>The images do not tell whether both volumes are of one patient.</source>
        <translation>Die Bilder sagen nicht, ob beide Volumen von einem Patienten sind.</translation>
    </message>
    <message>
        <source>The second volume is the study itself.</source>
        <translation>Das zweite Volumen ist die Studie selbst.</translation>
    </message>
    <message>
        <source>Choose another series by --second-series, of those that macula info lists, or another file by --second.</source>
        <translation>Wählen Sie mit --second-series eine andere Serie, von denen, die macula info aufzählt, oder mit --second eine andere Datei.</translation>
    </message>
    <message>
        <source>There is no second volume.</source>
        <translation>Es gibt kein zweites Volumen.</translation>
    </message>
    <message>
        <source>Give its folder or file by --second, or leave out what else is said of it.</source>
        <translation>Geben Sie seinen Ordner oder seine Datei mit --second an, oder lassen Sie weg, was sonst darüber gesagt ist.</translation>
    </message>
    <message>
        <source>The gradient opacity of the second volume&apos;s preset is not drawn.</source>
        <translation>Die Gradienten-Deckkraft der Voreinstellung des zweiten Volumens wird nicht gezeichnet.</translation>
    </message>
    <message>
        <source>The second volume&apos;s preset is drawn without its curves of steep matter.</source>
        <translation>Die Voreinstellung des zweiten Volumens wird ohne ihre Kurven für steile Materie gezeichnet.</translation>
    </message>
    <message>
        <source>Hiding segments</source>
        <translation>Segmente werden ausgeblendet</translation>
    </message>
    <message>
        <source>Hiding segments was cancelled.</source>
        <translation>Das Ausblenden der Segmente wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is not enough memory to hide segments.</source>
        <translation>Es ist nicht genug Speicher da, um Segmente auszublenden.</translation>
    </message>
    <message>
        <source>Close other programs, or hide fewer. The picture and what is chosen stay as before.</source>
        <translation>Schließen Sie andere Programme, oder blenden Sie weniger aus. Bild und Auswahl bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>More than 255 segments of different colours cannot be shown in 3D.</source>
        <translation>Mehr als 255 Segmente verschiedener Farben können in 3D nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>Colour fewer of them, or give some the same colour.</source>
        <translation>Färben Sie weniger davon, oder geben Sie einigen dieselbe Farbe.</translation>
    </message>
    <message>
        <source>Colouring segments</source>
        <translation>Segmente werden gefärbt</translation>
    </message>
    <message>
        <source>Colouring segments was cancelled.</source>
        <translation>Das Färben der Segmente wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is not enough memory to colour segments.</source>
        <translation>Es ist nicht genug Speicher da, um Segmente zu färben.</translation>
    </message>
    <message>
        <source>Close other programs, or colour fewer. The picture and what is chosen stay as before.</source>
        <translation>Schließen Sie andere Programme, oder färben Sie weniger. Bild und Auswahl bleiben, wie sie waren.</translation>
    </message>
    <message>
        <source>That does not say what to do with which segment.</source>
        <translation>Das sagt nicht, was mit welchem Segment geschehen soll.</translation>
    </message>
    <message>
        <source>Write keep:LABEL, hide:LABEL or colour:LABEL; macula info lists the labels.</source>
        <translation>Schreiben Sie keep:LABEL, hide:LABEL oder colour:LABEL; macula info zählt die Labels auf.</translation>
    </message>
    <message>
        <source>No segmentation of this volume has a segment of that label.</source>
        <translation>Keine Segmentierung dieses Volumens hat ein Segment mit diesem Label.</translation>
    </message>
    <message>
        <source>macula info lists the labels.</source>
        <translation>macula info zählt die Labels auf.</translation>
    </message>
    <message>
        <source>A segmentation of the view is not in the folder, and nothing of it is kept, hidden or coloured.</source>
        <translation>Eine Segmentierung der Ansicht ist nicht im Ordner, und nichts davon wird behalten, ausgeblendet oder gefärbt.</translation>
    </message>
    <message>
        <source>No voxel of these segments lies in the volume; all of it is shown.</source>
        <translation>Kein Voxel dieser Segmente liegt im Volumen; es wird ganz gezeigt.</translation>
    </message>
    <message>
        <source>Measurements are written to a .csv or .json file.</source>
        <translation>Messungen werden in eine .csv- oder .json-Datei geschrieben.</translation>
    </message>
    <message>
        <source>Choose a name with one of these endings.</source>
        <translation>Wählen Sie einen Namen mit einer dieser Endungen.</translation>
    </message>
    <message>
        <source>A window is kept under a name.</source>
        <translation>Eine Fensterung wird unter einem Namen behalten.</translation>
    </message>
    <message>
        <source>Type one, such as Kidney.</source>
        <translation>Geben Sie einen ein, zum Beispiel Niere.</translation>
    </message>
    <message>
        <source>There are {} windows of your own already.</source>
        <translation>Es gibt schon {} eigene Fensterungen.</translation>
    </message>
    <message>
        <source>namedClips: expected another thing.</source>
        <translation>namedClips: hier wird anderes erwartet.</translation>
    </message>
    <message>
        <source>A list of at most {} clips.</source>
        <translation>Eine Liste mit höchstens {} Beschnitten.</translation>
    </message>
    <message>
        <source>The view was saved of another series.</source>
        <translation>Die Ansicht wurde von einer anderen Serie gespeichert.</translation>
    </message>
    <message>
        <source>Open that series, or choose another view.</source>
        <translation>Öffnen Sie diese Serie, oder wählen Sie eine andere Ansicht.</translation>
    </message>
    <message>
        <source>The view was saved when the images lay in other places, or of another volume of the series.</source>
        <translation>Die Ansicht wurde gespeichert, als die Bilder an anderen Orten lagen, oder von einem anderen Volumen der Serie.</translation>
    </message>
    <message>
        <source>Make it anew; or choose the volume that it is of. Without &quot;grid&quot; in the file it is taken as it is.</source>
        <translation>Machen Sie sie neu, oder wählen Sie das Volumen, von dem sie ist. Ohne „grid“ in der Datei wird sie genommen, wie sie ist.</translation>
    </message>
    <message>
        <source>The values were not counted.</source>
        <translation>Die Werte wurden nicht gezählt.</translation>
    </message>
    <message>
        <source>The patient could not be told from the table.</source>
        <translation>Der Patient konnte nicht vom Tisch unterschieden werden.</translation>
    </message>
    <message>
        <source>Close other programs, or show the volume with the table.</source>
        <translation>Schließen Sie andere Programme, oder zeigen Sie das Volumen mit dem Tisch.</translation>
    </message>
    <message>
        <source>Telling the patient from the table was cancelled.</source>
        <translation>Die Suche nach dem Tisch wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Telling the patient from the table</source>
        <translation>Patient und Tisch werden unterschieden</translation>
    </message>
    <message>
        <source>The table can be left out of CT in Hounsfield units only.</source>
        <translation>Der Tisch kann nur bei CT in Hounsfield-Einheiten weggelassen werden.</translation>
    </message>
    <message>
        <source>Show these images with the table, or cut it away with a clip plane or box.</source>
        <translation>Zeigen Sie diese Bilder mit dem Tisch, oder schneiden Sie ihn mit einer Schnittebene oder einem Quader weg.</translation>
    </message>
    <message>
        <source>There is not enough memory to tell the patient from the table.</source>
        <translation>Es ist nicht genug Speicher da, um Patient und Tisch zu unterscheiden.</translation>
    </message>
    <message>
        <source>The copy of stored sessions was stopped.</source>
        <translation>Das Kopieren der gespeicherten Sitzungen wurde angehalten.</translation>
    </message>
    <message>
        <source>Copying stored models</source>
        <translation>Gespeicherte Modelle werden kopiert</translation>
    </message>
    <message>
        <source>Importing stored models</source>
        <translation>Gespeicherte Modelle werden importiert</translation>
    </message>
    <message>
        <source>Checking the database</source>
        <translation>Die Datenbank wird geprüft</translation>
    </message>
    <message>
        <source>Checking stored models</source>
        <translation>Gespeicherte Modelle werden geprüft</translation>
    </message>
    <message>
        <source>The check was stopped.</source>
        <translation>Die Prüfung wurde angehalten.</translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the folder or a file in it is read-only.</source>
        <translation>Sitzungen können nicht gespeichert werden: der Ordner oder eine Datei darin ist schreibgeschützt.</translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the disk is full.</source>
        <translation>Sitzungen können nicht gespeichert werden: der Datenträger ist voll.</translation>
    </message>
    <message>
        <source>Sessions cannot be stored: the drive cannot lock files.</source>
        <translation>Sitzungen können nicht gespeichert werden: das Laufwerk kann keine Dateien sperren.</translation>
    </message>
    <message>
        <source>Stored sessions are in use by another program.</source>
        <translation>Gespeicherte Sitzungen werden von einem anderen Programm benutzt.</translation>
    </message>
    <message>
        <source>The file of stored sessions is damaged.</source>
        <translation>Die Datei der gespeicherten Sitzungen ist beschädigt.</translation>
    </message>
    <message>
        <source>Stored sessions were written by a newer version of Macula.</source>
        <translation>Gespeicherte Sitzungen stammen von einer neueren Version von Macula.</translation>
    </message>
    <message>
        <source>The folder for sessions holds files of another program.</source>
        <translation>Der Ordner für Sitzungen enthält Dateien eines anderen Programms.</translation>
    </message>
    <message>
        <source>The disk reported an error while sessions were read or stored.</source>
        <translation>Der Datenträger meldete beim Lesen oder Speichern von Sitzungen einen Fehler.</translation>
    </message>
    <message>
        <source>There is not enough memory to read or store sessions.</source>
        <translation>Es ist nicht genug Speicher da, um Sitzungen zu lesen oder zu speichern.</translation>
    </message>
    <message>
        <source>A stored model is damaged; it was set aside.</source>
        <translation>Ein gespeichertes Modell ist beschädigt; es wurde beiseitegelegt.</translation>
    </message>
    <message>
        <source>A model is larger than all that may be stored.</source>
        <translation>Ein Modell ist größer als alles, was gespeichert werden darf.</translation>
    </message>
    <message>
        <source>The stored model is no longer there.</source>
        <translation>Das gespeicherte Modell ist nicht mehr da.</translation>
    </message>
    <message>
        <source>A stored setting is damaged; it was set aside.</source>
        <translation>Eine gespeicherte Einstellung ist beschädigt; sie wurde beiseitegelegt.</translation>
    </message>
    <message>
        <source>What is to be stored is no valid setting.</source>
        <translation>Was gespeichert werden soll, ist keine gültige Einstellung.</translation>
    </message>
    <message>
        <source>The folder holds no exported sessions.</source>
        <translation>Der Ordner enthält keine exportierten Sitzungen.</translation>
    </message>
    <message>
        <source>The data are deleted, but traces may remain in a file that another program is reading.</source>
        <translation>Die Daten sind gelöscht, aber Spuren können in einer Datei bleiben, die ein anderes Programm liest.</translation>
    </message>
    <message>
        <source>The series has {} segmentations.</source>
        <translation>Die Serie hat {} Segmentierungen.</translation>
    </message>
    <message>
        <source>Choose one of them with --volume.</source>
        <translation>Wählen Sie eines davon mit --volume.</translation>
    </message>
    <message>
        <source>There is no segmentation {}; the series has {}.</source>
        <translation>Es gibt keine Segmentierung {}; die Serie hat {}.</translation>
    </message>
    <message>
        <source>Choose another with --volume.</source>
        <translation>Wählen Sie mit --volume eine andere.</translation>
    </message>
    <message>
        <source>The slices are tilted against their axis, and the file says so; some programs do not understand that, and show the patient askew.</source>
        <translation>Die Schichten sind gegen ihre Achse geneigt, und die Datei sagt das; manche Programme verstehen es nicht und zeigen den Patienten schief.</translation>
    </message>
    <message>
        <source>There is no image.</source>
        <translation>Es gibt kein Bild.</translation>
    </message>
    <message>
        <source>There is not enough memory for a picture of the series.</source>
        <translation>Für ein Bild der Serie ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Choose a folder with a CT or MR series of several parallel slices.</source>
        <translation>Wählen Sie einen Ordner mit einer CT- oder MR-Serie aus mehreren parallelen Schichten.</translation>
    </message>
    <message>
        <source>Check its Series Instance UID or number, or choose another folder.</source>
        <translation>Prüfen Sie die Series Instance UID oder die Nummer, oder wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>The file is not a DICOM image.</source>
        <translation>Die Datei ist kein DICOM-Bild.</translation>
    </message>
    <message>
        <source>Choose another series; macula info lists them.</source>
        <translation>Wählen Sie eine andere Serie; macula info zählt sie auf.</translation>
    </message>
    <message>
        <source>See macula info for the list.</source>
        <translation>Die Liste zeigt macula info.</translation>
    </message>
    <message>
        <source>Choose another folder; macula info tells more about this one.</source>
        <translation>Wählen Sie einen anderen Ordner; macula info sagt mehr über diesen.</translation>
    </message>
    <message>
        <source>Several patients have a series of this UID.</source>
        <translation>Mehrere Patienten haben eine Serie mit dieser UID.</translation>
    </message>
    <message>
        <source>Choose by the number in front of it in macula info.</source>
        <translation>Wählen Sie nach der Nummer davor in macula info.</translation>
    </message>
    <message>
        <source>There is no such series in the folder.</source>
        <translation>Diese Serie gibt es im Ordner nicht.</translation>
    </message>
    <message>
        <source>See macula info for the list; --series takes the number in front (3, or 3.2 for its second stack), or the series UID.</source>
        <translation>Die Liste zeigt macula info; --series nimmt die Nummer davor (3, oder 3.2 für den zweiten Stapel) oder die UID der Serie.</translation>
    </message>
    <message>
        <source>The file is one volume; there is nothing to choose from.</source>
        <translation>Die Datei ist ein einziges Volumen; es gibt nichts auszuwählen.</translation>
    </message>
    <message>
        <source>Leave --series and --volume out.</source>
        <translation>Lassen Sie --series und --volume weg.</translation>
    </message>
    <message>
        <source>The phantom has no series to choose from.</source>
        <translation>Das Phantom hat keine Serien, aus denen zu wählen wäre.</translation>
    </message>
    <message>
        <source>Leave --series out.</source>
        <translation>Lassen Sie --series weg.</translation>
    </message>
    <message>
        <source>No folder was given: this is the built-in phantom.</source>
        <translation>Kein Ordner wurde angegeben: das ist das eingebaute Phantom.</translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation>Das Phantom wird erstellt</translation>
    </message>
    <message>
        <source>A series was asked for of what is no folder of DICOM images.</source>
        <translation>Eine Serie wurde verlangt, und das ist kein Ordner mit DICOM-Bildern.</translation>
    </message>
    <message>
        <source>Ask for none, or give a folder.</source>
        <translation>Verlangen Sie keine, oder wählen Sie einen Ordner.</translation>
    </message>
    <message>
        <source>This folder is of {}, and nothing says which is meant: {}.</source>
        <translation>Dieser Ordner ist von {}, und nichts sagt, welcher gemeint ist: {}.</translation>
    </message>
    <message>
        <source>Ask who knows the patient, and open one of the series by its Series Instance UID or by that number (series_uid).</source>
        <translation>Fragen Sie, wer den Patienten kennt, und öffnen Sie eine der Serien nach ihrer Series Instance UID oder nach dieser Nummer (series_uid).</translation>
    </message>
    <message>
        <source>Reading {} segmentations</source>
        <translation>{} Segmentierungen werden gelesen</translation>
    </message>
    <message>
        <source>Reading segmentations was cancelled.</source>
        <translation>Das Lesen der Segmentierungen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>It was drawn on other voxels than those of this volume; the nearest voxel is shown.</source>
        <translation>Sie wurde auf anderen Voxeln als denen dieses Volumens gezeichnet; das nächste Voxel wird gezeigt.</translation>
    </message>
    <message>
        <source>It has fractions; what is half or more is shown as the segment.</source>
        <translation>Sie hat Anteile; was die Hälfte oder mehr ist, wird als Segment gezeigt.</translation>
    </message>
    <message>
        <source>{} of its voxels lie outside of this volume, and are not counted.</source>
        <translation>{} ihrer Voxel liegen außerhalb dieses Volumens und werden nicht gezählt.</translation>
    </message>
    <message>
        <source>No voxel of it lies in this volume.</source>
        <translation>Kein Voxel davon liegt in diesem Volumen.</translation>
    </message>
    <message>
        <source>There is not enough memory for the headset.</source>
        <translation>Für das Headset ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>This build of Macula knows no headsets.</source>
        <translation>Diese Fassung von Macula kennt keine Headsets.</translation>
    </message>
    <message>
        <source>Build it with the package libopenxr-dev installed.</source>
        <translation>Bauen Sie sie, während das Paket libopenxr-dev installiert ist.</translation>
    </message>
    <message>
        <source>There is not enough memory.</source>
        <translation>Es ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>There is no folder for what the session keeps.</source>
        <translation>Es gibt keinen Ordner für das, was die Sitzung behält.</translation>
    </message>
    <message>
        <source>Say --sessions FOLDER, or set TMPDIR.</source>
        <translation>Geben Sie --sessions ORDNER an, oder setzen Sie TMPDIR.</translation>
    </message>
    <message>
        <source>There is no display to open a window on, or it does not answer.</source>
        <translation>Es gibt keine Anzeige für ein Fenster, oder sie antwortet nicht.</translation>
    </message>
    <message>
        <source>Set DISPLAY or WAYLAND_DISPLAY, or use `macula render`, which needs none.</source>
        <translation>Setzen Sie DISPLAY oder WAYLAND_DISPLAY, oder verwenden Sie `macula render`, das keine braucht.</translation>
    </message>
    <message>
        <source>There is not enough memory for these pictures.</source>
        <translation>Für diese Bilder ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Choose a smaller size, or close other programs.</source>
        <translation>Wählen Sie eine kleinere Größe, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>There is not enough memory for this picture.</source>
        <translation>Für dieses Bild ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>The presentation state could not be written.</source>
        <translation>Der Presentation State konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Choose another folder, and check free space and permissions.</source>
        <translation>Wählen Sie einen anderen Ordner, und prüfen Sie freien Platz und Rechte.</translation>
    </message>
    <message>
        <source>The presentation state could not be read.</source>
        <translation>Der Presentation State konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The file may be damaged; choose another one.</source>
        <translation>Die Datei ist vielleicht beschädigt; wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>There is not enough memory for both pictures.</source>
        <translation>Für beide Bilder ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>There is no preset to save yet.</source>
        <translation>Es gibt noch keine Voreinstellung zu speichern.</translation>
    </message>
    <message>
        <source>There is nothing to be seen yet.</source>
        <translation>Es ist noch nichts zu sehen.</translation>
    </message>
    <message>
        <source>The preset is gone.</source>
        <translation>Die Voreinstellung gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>Choose another one.</source>
        <translation>Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>There is not enough memory to read the presets.</source>
        <translation>Es ist nicht genug Speicher da, um die Voreinstellungen zu lesen.</translation>
    </message>
    <message>
        <source>There is not enough memory for small pictures.</source>
        <translation>Für kleine Bilder ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>There is not enough memory to measure.</source>
        <translation>Zum Messen ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>The file of settings is damaged.</source>
        <translation>Die Datei der Einstellungen ist beschädigt.</translation>
    </message>
    <message>
        <source>The usual settings are taken; what you set next is saved, and the damaged file is kept.</source>
        <translation>Es gelten die üblichen Einstellungen; was Sie als Nächstes einstellen, wird gespeichert, und die beschädigte Datei bleibt erhalten.</translation>
    </message>
    <message>
        <source>The settings could not be saved: their folder cannot be made.</source>
        <translation>Die Einstellungen konnten nicht gespeichert werden: ihr Ordner kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>There is not enough memory to keep windows.</source>
        <translation>Es ist nicht genug Speicher da, um Fensterungen zu behalten.</translation>
    </message>
    <message>
        <source>There is not enough memory to count the values.</source>
        <translation>Es ist nicht genug Speicher da, um die Werte zu zählen.</translation>
    </message>
    <message>
        <source>Close other programs, and open the study again.</source>
        <translation>Schließen Sie andere Programme, und öffnen Sie die Studie noch einmal.</translation>
    </message>
    <message>
        <source>This kind of display cannot show Vulkan pictures.</source>
        <translation>Diese Art von Anzeige kann keine Vulkan-Bilder zeigen.</translation>
    </message>
    <message>
        <source>Use an X11 or a Wayland display, or `macula render`.</source>
        <translation>Verwenden Sie eine X11- oder Wayland-Anzeige, oder `macula render`.</translation>
    </message>
    <message>
        <source>The window cannot show Vulkan pictures.</source>
        <translation>Das Fenster kann keine Vulkan-Bilder zeigen.</translation>
    </message>
    <message>
        <source>Install a Vulkan driver for this display.</source>
        <translation>Installieren Sie einen Vulkan-Treiber für diese Anzeige.</translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation>Keine Studie ist offen.</translation>
    </message>
    <message>
        <source>Open the study that the view is of first.</source>
        <translation>Öffnen Sie zuerst die Studie der Ansicht.</translation>
    </message>
    <message>
        <source>The folder for pictures is not there.</source>
        <translation>Den Ordner für Bilder gibt es nicht.</translation>
    </message>
    <message>
        <source>Make it, or choose another one.</source>
        <translation>Legen Sie ihn an, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>The folder for pictures is full of them.</source>
        <translation>Der Ordner für Bilder ist voll davon.</translation>
    </message>
    <message>
        <source>Empty it, or choose another one.</source>
        <translation>Leeren Sie ihn, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>The headset does not say where the eyes are, or what they see.</source>
        <translation>Das Headset sagt nicht, wo die Augen sind oder was sie sehen.</translation>
    </message>
    <message>
        <source>Put the headset on, and restart its software if that does not help.</source>
        <translation>Setzen Sie das Headset auf, und starten Sie seine Software neu, wenn das nicht hilft.</translation>
    </message>
    <message>
        <source>The headset asks for a picture of 170 degrees or more.</source>
        <translation>Das Headset verlangt ein Bild von 170 Grad oder mehr.</translation>
    </message>
    <message>
        <source>Restart the software of the headset.</source>
        <translation>Starten Sie die Software des Headsets neu.</translation>
    </message>
    <message>
        <source>The software of the headset does not answer as OpenXR 1.0 demands.</source>
        <translation>Die Software des Headsets antwortet nicht, wie es OpenXR 1.0 verlangt.</translation>
    </message>
    <message>
        <source>Update or reinstall it.</source>
        <translation>Aktualisieren Sie sie, oder installieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The OpenXR loader is not installed, so no headset can be found.</source>
        <translation>Der Loader von OpenXR ist nicht installiert, daher kann kein Headset gefunden werden.</translation>
    </message>
    <message>
        <source>Install it (Debian/Ubuntu: sudo apt install libopenxr-loader1).</source>
        <translation>Installieren Sie ihn (Debian/Ubuntu: sudo apt install libopenxr-loader1).</translation>
    </message>
    <message>
        <source>In a headset only path-traced pictures can be shown.</source>
        <translation>In einem Headset können nur Bilder mit Pfadverfolgung gezeigt werden.</translation>
    </message>
    <message>
        <source>Choose the cinematic or the clear look.</source>
        <translation>Wählen Sie die Darstellung Cinematic oder Klar.</translation>
    </message>
    <message>
        <source>These lights hang on the camera, and in a headset there are two eyes.</source>
        <translation>Diese Beleuchtung hängt an der Kamera, und in einem Headset gibt es zwei Augen.</translation>
    </message>
    <message>
        <source>Choose lights that stay in place; macula presets lists them.</source>
        <translation>Wählen Sie eine Beleuchtung, die an ihrem Ort bleibt; macula presets zählt sie auf.</translation>
    </message>
    <message>
        <source>Nothing of this study can be seen.</source>
        <translation>Von dieser Studie ist nichts zu sehen.</translation>
    </message>
    <message>
        <source>Choose another preset, or another clip.</source>
        <translation>Wählen Sie eine andere Voreinstellung oder einen anderen Beschnitt.</translation>
    </message>
    <message>
        <source>The OpenXR runtime that XR_RUNTIME_JSON names cannot be loaded.</source>
        <translation>Die OpenXR-Runtime, die XR_RUNTIME_JSON nennt, kann nicht geladen werden.</translation>
    </message>
    <message>
        <source>Correct or unset XR_RUNTIME_JSON.</source>
        <translation>Berichtigen oder entfernen Sie XR_RUNTIME_JSON.</translation>
    </message>
    <message>
        <source>The software of the headset cannot show pictures made with Vulkan (XR_KHR_vulkan_enable2).</source>
        <translation>Die Software des Headsets kann keine Bilder zeigen, die mit Vulkan gemacht sind (XR_KHR_vulkan_enable2).</translation>
    </message>
    <message>
        <source>Update it, or use another OpenXR runtime.</source>
        <translation>Aktualisieren Sie sie, oder verwenden Sie eine andere OpenXR-Runtime.</translation>
    </message>
    <message>
        <source>The headset does not say how large its pictures are.</source>
        <translation>Das Headset sagt nicht, wie groß seine Bilder sind.</translation>
    </message>
    <message>
        <source>Update the software of the headset.</source>
        <translation>Aktualisieren Sie die Software des Headsets.</translation>
    </message>
    <message>
        <source>The headset needs another version of Vulkan.</source>
        <translation>Das Headset braucht eine andere Version von Vulkan.</translation>
    </message>
    <message>
        <source>The headset takes no pictures of 8 bits in sRGB (R8G8B8A8_SRGB).</source>
        <translation>Das Headset nimmt keine Bilder mit 8 Bit in sRGB (R8G8B8A8_SRGB).</translation>
    </message>
    <message>
        <source>The headset has ended the session: it was unplugged or fell asleep.</source>
        <translation>Das Headset hat die Sitzung beendet: es wurde ausgesteckt oder ist eingeschlafen.</translation>
    </message>
    <message>
        <source>Wake it up or plug it in, and begin again; nothing that was chosen is lost.</source>
        <translation>Wecken Sie es, oder stecken Sie es ein, und beginnen Sie noch einmal; nichts, was gewählt war, ist verloren.</translation>
    </message>
    <message>
        <source>The software of the headset has stopped.</source>
        <translation>Die Software des Headsets hat angehalten.</translation>
    </message>
    <message>
        <source>Start it again, and begin again; nothing that was chosen is lost.</source>
        <translation>Starten Sie sie wieder, und beginnen Sie noch einmal; nichts, was gewählt war, ist verloren.</translation>
    </message>
    <message>
        <source>No software of a headset (OpenXR runtime) answers.</source>
        <translation>Keine Software eines Headsets (OpenXR-Runtime) antwortet.</translation>
    </message>
    <message>
        <source>Start SteamVR, Monado or what came with the headset, and make it the active OpenXR runtime.</source>
        <translation>Starten Sie SteamVR, Monado oder was dem Headset beilag, und machen Sie es zur aktiven OpenXR-Runtime.</translation>
    </message>
    <message>
        <source>No headset is connected, or it is switched off.</source>
        <translation>Kein Headset ist angeschlossen, oder es ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>Connect the headset, switch it on, and try again.</source>
        <translation>Schließen Sie das Headset an, schalten Sie es ein, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The OpenXR runtime knows no headsets.</source>
        <translation>Die OpenXR-Runtime kennt keine Headsets.</translation>
    </message>
    <message>
        <source>Make the runtime of the headset the active one.</source>
        <translation>Machen Sie die Runtime des Headsets zur aktiven.</translation>
    </message>
    <message>
        <source>The headset could not {}.</source>
        <translation>Das Headset konnte dies nicht: {}.</translation>
    </message>
    <message>
        <source>Copy the whole series again from its source.</source>
        <translation>Kopieren Sie die ganze Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Look at these images by themselves, or copy the series again from its source.</source>
        <translation>Sehen Sie sich diese Bilder einzeln an, oder kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Export the series again, or choose another.</source>
        <translation>Exportieren Sie die Serie noch einmal, oder wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>No file of this series can be read; it has {count}.</source>
        <translation>Keine Datei dieser Serie kann gelesen werden; sie hat {count}.</translation>
    </message>
    <message>
        <source>A file cannot be opened.</source>
        <translation>Eine Datei kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>A file is listed in the folder, and its content is not on this machine.</source>
        <translation>Eine Datei steht im Ordner, aber ihr Inhalt ist nicht auf diesem Rechner.</translation>
    </message>
    <message>
        <source>Connect the drive, or make the files available offline.</source>
        <translation>Verbinden Sie das Laufwerk, oder machen Sie die Dateien offline verfügbar.</translation>
    </message>
    <message>
        <source>The medium gave an error where something was to be read from it: it is damaged, dirty or failing.</source>
        <translation>Das Medium meldete einen Fehler, als etwas gelesen werden sollte: Es ist beschädigt, verschmutzt oder am Versagen.</translation>
    </message>
    <message>
        <source>Clean the disc, or check drive and cable, and copy the medium again; else ask for another copy.</source>
        <translation>Reinigen Sie die Disc, oder prüfen Sie Laufwerk und Kabel, und kopieren Sie das Medium noch einmal; sonst bitten Sie um eine andere Kopie.</translation>
    </message>
    <message>
        <source>A path is longer than this system can open; what lies there is missing here.</source>
        <translation>Ein Pfad ist länger, als dieses System öffnen kann; was dort liegt, fehlt hier.</translation>
    </message>
    <message>
        <source>A DICOM file is damaged and cannot be read.</source>
        <translation>Eine DICOM-Datei ist beschädigt und kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>A DICOM file ends before its pixel data do.</source>
        <translation>Eine DICOM-Datei endet vor ihren Pixeldaten.</translation>
    </message>
    <message>
        <source>A DICOM image has no pixel data.</source>
        <translation>Ein DICOM-Bild hat keine Pixeldaten.</translation>
    </message>
    <message>
        <source>A DICOM image does not say in a number how many frames it has.</source>
        <translation>Ein DICOM-Bild sagt nicht mit einer Zahl, wie viele Einzelbilder es hat.</translation>
    </message>
    <message>
        <source>Frames that the files of this series should have, and that are not there: {missing} of {total}.</source>
        <translation>Einzelbilder, die die Dateien dieser Serie haben sollten und die fehlen: {missing} von {total}.</translation>
    </message>
    <message>
        <source>Files that hold more than the number of frames they give (NumberOfFrames): {files}. What is beyond is not shown: pixels or descriptions of {frames} frames.</source>
        <translation>Dateien, die mehr enthalten, als die Zahl ihrer Einzelbilder (NumberOfFrames) angibt: {files}. Was darüber hinausgeht, wird nicht gezeigt: Pixel oder Beschreibungen von {frames} Einzelbildern.</translation>
    </message>
    <message>
        <source>Slices may be missing here; copy the series again from its source.</source>
        <translation>Hier können Schichten fehlen; kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Bytes follow the pixel data in some files and are no part of the images, which are whole: up to {bytes}.</source>
        <translation>In manchen Dateien folgen auf die Pixeldaten Bytes, die nicht zu den Bildern gehören; diese sind vollständig: bis zu {bytes}.</translation>
    </message>
    <message>
        <source>Images in which attributes stand twice, with different values: {count} of {total} ({attributes}). Of each the first value is used.</source>
        <translation>Bilder, in denen Attribute zweimal mit verschiedenen Werten stehen: {count} von {total} ({attributes}). Von jedem gilt der erste Wert.</translation>
    </message>
    <message>
        <source>Compare values and sizes with those that another program shows; have the images set right.</source>
        <translation>Vergleichen Sie Werte und Größen mit denen, die ein anderes Programm zeigt; lassen Sie die Bilder berichtigen.</translation>
    </message>
    <message>
        <source>Files of this series that do not say what kind of object they are: {count}.</source>
        <translation>Dateien dieser Serie, die nicht sagen, was für ein Objekt sie sind: {count}.</translation>
    </message>
    <message>
        <source>Check that the series is what it seems to be.</source>
        <translation>Prüfen Sie, ob die Serie ist, was sie zu sein scheint.</translation>
    </message>
    <message>
        <source>Images that do not say by what kind of device they were taken (Modality): {count} of {total}; they were taken for {modality}.</source>
        <translation>Bilder, die nicht sagen, mit was für einem Gerät sie aufgenommen wurden (Modality): {count} von {total}; sie gelten als {modality}.</translation>
    </message>
    <message>
        <source>Folders that could not be read: {count}. Images in them are missing here.</source>
        <translation>Ordner, die nicht gelesen werden konnten: {count}. Bilder darin fehlen hier.</translation>
    </message>
    <message>
        <source>Check the permissions of the folders, or copy the study again.</source>
        <translation>Prüfen Sie die Zugriffsrechte der Ordner, oder kopieren Sie die Studie noch einmal.</translation>
    </message>
    <message>
        <source>Links that lead out of the chosen folder, and were not followed: {count}.</source>
        <translation>Verknüpfungen, die aus dem gewählten Ordner führen und denen nicht gefolgt wurde: {count}.</translation>
    </message>
    <message>
        <source>Choose the folder they lead to, if it is wanted.</source>
        <translation>Wählen Sie den Ordner, zu dem sie führen, wenn er gewünscht ist.</translation>
    </message>
    <message>
        <source>Archives ({kinds}) in the folder, which were not opened: {count}.</source>
        <translation>Archive ({kinds}) im Ordner, die nicht geöffnet wurden: {count}.</translation>
    </message>
    <message>
        <source>Unpack those that hold images of this study, and open the folder again.</source>
        <translation>Entpacken Sie die, in denen Bilder dieser Studie sind, und öffnen Sie den Ordner noch einmal.</translation>
    </message>
    <message>
        <source>Files that the directory of this medium (DICOMDIR) lists and that are not there: {count}.</source>
        <translation>Dateien, die das Verzeichnis dieses Mediums (DICOMDIR) aufführt und die fehlen: {count}.</translation>
    </message>
    <message>
        <source>Copy the medium again; images may be missing.</source>
        <translation>Kopieren Sie das Medium noch einmal; Bilder können fehlen.</translation>
    </message>
    <message>
        <source>The images say that their study has {total} objects (NumberOfStudyRelatedInstances); {count} of it are here.</source>
        <translation>Die Bilder sagen, dass ihre Studie {total} Objekte hat (NumberOfStudyRelatedInstances); davon sind {count} hier.</translation>
    </message>
    <message>
        <source>Copy the study again from its source if all of it should be here.</source>
        <translation>Kopieren Sie die Studie noch einmal von ihrer Quelle, wenn sie ganz hier sein soll.</translation>
    </message>
    <message>
        <source>Files that the directory of this medium (DICOMDIR) names outside the chosen folder, and that were not read: {count}.</source>
        <translation>Dateien, die das Verzeichnis dieses Mediums (DICOMDIR) außerhalb des gewählten Ordners nennt und die nicht gelesen wurden: {count}.</translation>
    </message>
    <message>
        <source>Take care where this medium comes from.</source>
        <translation>Achten Sie darauf, woher dieses Medium kommt.</translation>
    </message>
    <message>
        <source>The directory of this medium (DICOMDIR) cannot be read; the files themselves were read.</source>
        <translation>Das Verzeichnis dieses Mediums (DICOMDIR) kann nicht gelesen werden; die Dateien selbst wurden gelesen.</translation>
    </message>
    <message>
        <source>Files that are copies of others of this series, and were left out: {count}.</source>
        <translation>Dateien, die Kopien anderer dieser Serie sind und weggelassen wurden: {count}.</translation>
    </message>
    <message>
        <source>Images that have the identifier of another of this series, in a file that differs: {count}. Of each the first file is used; the others are in a stack of their own.</source>
        <translation>Bilder mit der Kennung eines anderen dieser Serie in einer abweichenden Datei: {count}. Von jedem wird die erste Datei verwendet; die anderen liegen in einem eigenen Stapel.</translation>
    </message>
    <message>
        <source>Compare them before relying on this series.</source>
        <translation>Vergleichen Sie sie, bevor Sie sich auf diese Serie verlassen.</translation>
    </message>
    <message>
        <source>Files of this series that cannot be read, and were left out: {count}.</source>
        <translation>Dateien dieser Serie, die nicht gelesen werden können und weggelassen wurden: {count}.</translation>
    </message>
    <message>
        <source>Copy the series again from its source.</source>
        <translation>Kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Text of this series does not fit the character set it declares; names may be shown wrongly.</source>
        <translation>Text dieser Serie passt nicht zu ihrem angegebenen Zeichensatz; Namen können falsch gezeigt werden.</translation>
    </message>
    <message>
        <source>The files of this series name different patients or studies, and were split into {count} series.</source>
        <translation>Die Dateien dieser Serie nennen verschiedene Patienten oder Studien und wurden in {count} Serien geteilt.</translation>
    </message>
    <message>
        <source>Check name, ID, birth date and sex of the patient in every part; slices of this patient may lie in another part.</source>
        <translation>Prüfen Sie Name, ID, Geburtsdatum und Geschlecht des Patienten in jedem Teil; Schichten dieses Patienten können in einem anderen Teil liegen.</translation>
    </message>
    <message>
        <source>The images differ in {attributes}, and were separated into {count} stacks.</source>
        <translation>Die Bilder unterscheiden sich in {attributes} und wurden in {count} Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images have different sizes, and were separated into {count} stacks.</source>
        <translation>Die Bilder haben verschiedene Größen und wurden in {count} Stapel getrennt.</translation>
    </message>
    <message>
        <source>Some images are in colour and others are not; they were separated into {count} stacks.</source>
        <translation>Manche Bilder sind farbig und andere nicht; sie wurden in {count} Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images lie in different orientations, and were separated into {count} stacks.</source>
        <translation>Die Bilder haben verschiedene Ausrichtungen und wurden in {count} Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images do not share one coordinate system, or some have no position; they were separated into {count} stacks.</source>
        <translation>Die Bilder haben kein gemeinsames Koordinatensystem, oder manche haben keine Position; sie wurden in {count} Stapel getrennt.</translation>
    </message>
    <message>
        <source>The images have different pixel spacings, and were separated into {count} stacks.</source>
        <translation>Die Bilder haben verschiedene Pixelabstände und wurden in {count} Stapel getrennt.</translation>
    </message>
    <message>
        <source>Images whose values are in another unit than those of the others, and that are a stack of their own: {count} ({unit}).</source>
        <translation>Bilder, deren Werte in einer anderen Einheit sind als die der übrigen und die ein eigener Stapel sind: {count} ({unit}).</translation>
    </message>
    <message>
        <source>Look at both; values of one cannot be compared with those of the other.</source>
        <translation>Sehen Sie sich beide an; die Werte des einen sind nicht mit denen des anderen vergleichbar.</translation>
    </message>
    <message>
        <source>Every position was imaged {count} times; each is a volume of its own, told apart by {attribute}.</source>
        <translation>Jede Position wurde {count}-mal aufgenommen; jede ist ein eigenes Volumen, unterschieden durch {attribute}.</translation>
    </message>
    <message>
        <source>Every position was imaged {count} times, and only the order of the image numbers tells them apart.</source>
        <translation>Jede Position wurde {count}-mal aufgenommen, und nur die Reihenfolge der Bildnummern unterscheidet sie.</translation>
    </message>
    <message>
        <source>Check that the volumes of this series are what they seem to be.</source>
        <translation>Prüfen Sie, ob die Volumen dieser Serie sind, was sie zu sein scheinen.</translation>
    </message>
    <message>
        <source>Images whose {attribute} does not say to which phase they belong, and whose number was asked instead: {numbers}.</source>
        <translation>Bilder, deren {attribute} nicht sagt, zu welcher Phase sie gehören, und deren Nummer stattdessen entschied: {numbers}.</translation>
    </message>
    <message>
        <source>Compare these slices with those beside them before relying on them.</source>
        <translation>Vergleichen Sie diese Schichten mit denen daneben, bevor Sie sich auf sie verlassen.</translation>
    </message>
    <message>
        <source>Images of which nothing says for sure to which acquisition or phase they belong: {numbers}. They are in a stack of their own, and the others lack them.</source>
        <translation>Bilder, von denen nichts sicher sagt, zu welcher Aufnahme oder Phase sie gehören: {numbers}. Sie sind ein eigener Stapel, und den anderen fehlen sie.</translation>
    </message>
    <message>
        <source>Look at these images by themselves; part of the scan may have been repeated.</source>
        <translation>Sehen Sie diese Bilder für sich an; ein Teil der Aufnahme wurde vielleicht wiederholt.</translation>
    </message>
    <message>
        <source>Phases that have fewer images than the others: {count} of {total}.</source>
        <translation>Phasen, die weniger Bilder haben als die anderen: {count} von {total}.</translation>
    </message>
    <message>
        <source>Images that lie at the same position as another: {count} of {total}. Nothing in them says which belong together.</source>
        <translation>Bilder an derselben Position wie ein anderes: {count} von {total}. Nichts darin sagt, welche zusammengehören.</translation>
    </message>
    <message>
        <source>Which images make a volume? Choose another series, or separate the files of this one by hand.</source>
        <translation>Welche Bilder ergeben ein Volumen? Wählen Sie eine andere Serie, oder trennen Sie die Dateien dieser von Hand.</translation>
    </message>
    <message>
        <source>Positions that were imaged more than once: {count}. Of each, the image with the lowest number is in the volume, and the others are in a stack of their own.</source>
        <translation>Positionen, die mehrmals aufgenommen wurden: {count}. Von jeder ist das Bild mit der kleinsten Nummer im Volumen, die anderen liegen in einem eigenen Stapel.</translation>
    </message>
    <message>
        <source>Compare the repeated images before relying on these slices.</source>
        <translation>Vergleichen Sie die wiederholten Bilder, bevor Sie sich auf diese Schichten verlassen.</translation>
    </message>
    <message>
        <source>Files of those that make up one image that are not here: {missing} of {total}.</source>
        <translation>Dateien, die zusammen ein Bild ergeben und hier fehlen: {missing} von {total}.</translation>
    </message>
    <message>
        <source>Slices that seem to be missing beyond the end towards the {side}: {count}; {evidence}.</source>
        <translation>Schichten, die jenseits des Endes zu fehlen scheinen ({side}): {count}; {evidence}.</translation>
    </message>
    <message>
        <source>Copy the whole series again from its source; what lies beyond this end is not shown.</source>
        <translation>Kopieren Sie die ganze Serie noch einmal von ihrer Quelle; was jenseits dieses Endes liegt, wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>Images of this series that seem to be missing: {count}; {evidence}.</source>
        <translation>Bilder dieser Serie, die zu fehlen scheinen: {count}; {evidence}.</translation>
    </message>
    <message>
        <source>Copy the whole series again from its source; the slices may end too early.</source>
        <translation>Kopieren Sie die ganze Serie noch einmal von ihrer Quelle; die Schichten enden vielleicht zu früh.</translation>
    </message>
    <message>
        <source>{other} of this study reaches {mm:.0f} mm farther towards the {side} than these slices.</source>
        <translation>{other} dieser Studie reicht {mm:.0f} mm weiter als diese Schichten ({side}).</translation>
    </message>
    <message>
        <source>If both should cover the same, images are missing here: compare with the source.</source>
        <translation>Sollten beide dasselbe abdecken, fehlen hier Bilder: Vergleichen Sie mit der Quelle.</translation>
    </message>
    <message>
        <source>Series {number} of this study continues this stack, with the same slice distance.</source>
        <translation>Serie {number} dieser Studie setzt diesen Stapel mit demselben Schichtabstand fort.</translation>
    </message>
    <message>
        <source>Look at both; together they cover more.</source>
        <translation>Sehen Sie beide an; zusammen decken sie mehr ab.</translation>
    </message>
    <message>
        <source>This is a localizer: an overview image, not a slice of a volume.</source>
        <translation>Das ist ein Localizer: ein Übersichtsbild, keine Schicht eines Volumens.</translation>
    </message>
    <message>
        <source>Choose a series of slices.</source>
        <translation>Wählen Sie eine Serie von Schichten.</translation>
    </message>
    <message>
        <source>The image numbers run {count} times along the patient, and nothing else tells these sets of slices apart; each is a stack of its own.</source>
        <translation>Die Bildnummern laufen {count}-mal am Patienten entlang, und nichts sonst unterscheidet diese Sätze von Schichten; jeder ist ein eigener Stapel.</translation>
    </message>
    <message>
        <source>Look at all of them; they may be several acquisitions.</source>
        <translation>Sehen Sie alle an; es sind vielleicht mehrere Aufnahmen.</translation>
    </message>
    <message>
        <source>The slices are {count} even sets, the first two shifted by {offsetMm:.3f} mm against each other, and nothing else tells them apart; each is a stack of its own.</source>
        <translation>Die Schichten sind {count} gleichmäßige Sätze, die ersten beiden um {offsetMm:.3f} mm gegeneinander verschoben, und nichts sonst unterscheidet sie; jeder ist ein eigener Stapel.</translation>
    </message>
    <message>
        <source>{attribute} changes along the slices, first at slice {slice}; values may step there.</source>
        <translation>{attribute} ändert sich entlang der Schichten, zuerst bei Schicht {slice}; dort können Werte springen.</translation>
    </message>
    <message>
        <source>Do not take a step there for a finding.</source>
        <translation>Halten Sie einen Sprung dort nicht für einen Befund.</translation>
    </message>
    <message>
        <source>Slices {slices} were acquired {minutes:.1f} min before or after those beside them: the patient may have moved, and contrast medium spread.</source>
        <translation>Die Schichten {slices} wurden {minutes:.1f} min vor oder nach denen daneben aufgenommen: Der Patient kann sich bewegt und Kontrastmittel sich ausgebreitet haben.</translation>
    </message>
    <message>
        <source>Every other slice differs from those beside it in the same way: two acquisitions may be mixed in this volume.</source>
        <translation>Jede zweite Schicht weicht in gleicher Weise von ihren Nachbarn ab: in diesem Volumen können zwei Aufnahmen vermischt sein.</translation>
    </message>
    <message>
        <source>Compare the original images, slice by slice, before relying on this volume.</source>
        <translation>Vergleichen Sie die Originalbilder Schicht für Schicht, bevor Sie sich auf dieses Volumen verlassen.</translation>
    </message>
    <message>
        <source>The images lie in {count} blocks, up to {gapMm:.0f} mm apart; each is a stack of its own, so what is shown is one of {count}.</source>
        <translation>Die Bilder liegen in {count} Blöcken, bis zu {gapMm:.0f} mm auseinander; jeder ist ein eigener Stapel, gezeigt wird also einer von {count}.</translation>
    </message>
    <message>
        <source>Look at the other blocks too.</source>
        <translation>Sehen Sie auch die anderen Blöcke an.</translation>
    </message>
    <message>
        <source>Every image names a coordinate system (FrameOfReferenceUID) of its own, and together they make an even stack; it was taken for granted that they share one.</source>
        <translation>Jedes Bild nennt ein eigenes Koordinatensystem (FrameOfReferenceUID), und zusammen ergeben sie einen gleichmäßigen Stapel; es wurde angenommen, dass sie eines teilen.</translation>
    </message>
    <message>
        <source>Check that the slices fit each other. The series is not shown together with others.</source>
        <translation>Prüfen Sie, ob die Schichten zueinander passen. Die Serie wird nicht zusammen mit anderen gezeigt.</translation>
    </message>
    <message>
        <source>Images that name no coordinate system (FrameOfReferenceUID): {count} of {total}. They continue the stack of the others, and it was taken for granted that they share theirs.</source>
        <translation>Bilder, die kein Koordinatensystem (FrameOfReferenceUID) nennen: {count} von {total}. Sie setzen den Stapel der anderen fort, und es wurde angenommen, dass sie deren teilen.</translation>
    </message>
    <message>
        <source>The frames belong to {count} stacks (StackID), which make one even volume together and are shown as one.</source>
        <translation>Die Bilder gehören zu {count} Stapeln (StackID), die zusammen ein gleichmäßiges Volumen ergeben und als eines gezeigt werden.</translation>
    </message>
    <message>
        <source>Images that share one identifier (SOPInstanceUID) and lie at different positions: {count}. All are kept.</source>
        <translation>Bilder, die eine Kennung (SOPInstanceUID) teilen und an verschiedenen Positionen liegen: {count}. Alle bleiben.</translation>
    </message>
    <message>
        <source>Other programs may show only one of them; have the identifiers set right.</source>
        <translation>Andere Programme zeigen vielleicht nur eines davon; lassen Sie die Kennungen berichtigen.</translation>
    </message>
    <message>
        <source>Images that repeat another at the same position, pixel by pixel, and were left out: {count}.</source>
        <translation>Bilder, die ein anderes an derselben Position Pixel für Pixel wiederholen und weggelassen wurden: {count}.</translation>
    </message>
    <message>
        <source>Nothing is lost; the series was probably sent twice.</source>
        <translation>Nichts ist verloren; die Serie wurde wohl zweimal gesendet.</translation>
    </message>
    <message>
        <source>{count} images have a {level} identifier each and would make one even stack together.</source>
        <translation>{count} Bilder haben je eine eigene Kennung ({level}) und ergäben zusammen einen gleichmäßigen Stapel.</translation>
    </message>
    <message>
        <source>Are they one series? Then open the folder with --join.</source>
        <translation>Sind sie eine Serie? Dann öffnen Sie den Ordner mit --join.</translation>
    </message>
    <message>
        <source>{count} images with a {level} identifier each were joined to this series because that was asked for.</source>
        <translation>{count} Bilder mit je einer eigenen Kennung ({level}) wurden zu dieser Serie verbunden, weil das verlangt wurde.</translation>
    </message>
    <message>
        <source>Check that all of them are of one patient and one examination.</source>
        <translation>Prüfen Sie, ob alle von einem Patienten und einer Untersuchung sind.</translation>
    </message>
    <message>
        <source>There is only one slice.</source>
        <translation>Es gibt nur eine Schicht.</translation>
    </message>
    <message>
        <source>Choose a series with more slices.</source>
        <translation>Wählen Sie eine Serie mit mehr Schichten.</translation>
    </message>
    <message>
        <source>The images do not say where they lie in the patient.</source>
        <translation>Die Bilder sagen nicht, wo sie im Patienten liegen.</translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say where they lie in the patient.</source>
        <translation>Die Einzelbilder dieses Multiframe-Bildes sagen nicht, wo sie im Patienten liegen.</translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say how they are oriented in the patient.</source>
        <translation>Die Einzelbilder dieses Multiframe-Bildes sagen nicht, wie sie im Patienten ausgerichtet sind.</translation>
    </message>
    <message>
        <source>The frames of this multi-frame image do not say how large a pixel is.</source>
        <translation>Die Einzelbilder dieses Multiframe-Bildes sagen nicht, wie groß ein Pixel ist.</translation>
    </message>
    <message>
        <source>The images do not say how large a pixel is.</source>
        <translation>Die Bilder sagen nicht, wie groß ein Pixel ist.</translation>
    </message>
    <message>
        <source>The images say where they lie in a frame of the transducer, and not in the patient: letters of sides, and left and right, are not those of the patient.</source>
        <translation>Die Bilder sagen, wo sie in einem System des Schallkopfs liegen, und nicht im Patienten: Buchstaben der Seiten, und links und rechts, sind nicht die des Patienten.</translation>
    </message>
    <message>
        <source>Do not tell sides from this volume.</source>
        <translation>Lesen Sie an diesem Volumen keine Seiten ab.</translation>
    </message>
    <message>
        <source>Only the first frame says where it lies; it was taken for granted that the others follow it along the slice normal, at the distance that the file gives.</source>
        <translation>Nur das erste Einzelbild sagt, wo es liegt; es wurde vorausgesetzt, dass die anderen ihm entlang der Schichtnormalen folgen, im Abstand, den die Datei nennt.</translation>
    </message>
    <message>
        <source>If they run the other way, the volume is mirrored: compare with a marker of the side.</source>
        <translation>Laufen sie andersherum, ist das Volumen gespiegelt: Vergleichen Sie mit einer Seitenmarkierung.</translation>
    </message>
    <message>
        <source>{attribute} is not written as numbers with backslashes between them, and can be read in no way, or in several.</source>
        <translation>{attribute} ist nicht als Zahlen mit umgekehrten Schrägstrichen dazwischen geschrieben und ist gar nicht oder auf mehrere Arten zu lesen.</translation>
    </message>
    <message>
        <source>Have it set right, or export the series again.</source>
        <translation>Lassen Sie es richtigstellen, oder exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>Images whose position, orientation or pixel spacing has other signs between its numbers, or in them, than it should: {count} of {total}. It was read in the only way that there is.</source>
        <translation>Bilder, deren Position, Orientierung oder Pixelabstand andere Zeichen zwischen den Zahlen oder in ihnen hat, als sie sollten: {count} von {total}. Es wurde auf die einzige Art gelesen, die es gibt.</translation>
    </message>
    <message>
        <source>Measure a known length before relying on sizes.</source>
        <translation>Messen Sie eine bekannte Länge, bevor Sie sich auf Größen verlassen.</translation>
    </message>
    <message>
        <source>The size of a pixel is not calibrated; it was taken from {source}.</source>
        <translation>Die Pixelgröße ist nicht kalibriert; sie stammt aus: {source}.</translation>
    </message>
    <message>
        <source>Do not measure lengths in these images.</source>
        <translation>Messen Sie in diesen Bildern keine Längen.</translation>
    </message>
    <message>
        <source>The orientation or pixel spacing of a slice is not a valid one.</source>
        <translation>Die Ausrichtung oder der Pixelabstand einer Schicht ist ungültig.</translation>
    </message>
    <message>
        <source>The letters of the sides (PatientOrientation) say the opposite of the orientation in space (ImageOrientationPatient), which is used, in {count} of {total} images.</source>
        <translation>Die Buchstaben der Seiten (PatientOrientation) sagen das Gegenteil der Orientierung im Raum (ImageOrientationPatient), die verwendet wird, in {count} von {total} Bildern.</translation>
    </message>
    <message>
        <source>Left and right, or front and back, may be exchanged: compare with the original images.</source>
        <translation>Links und rechts oder vorn und hinten können vertauscht sein: Vergleichen Sie mit den Originalbildern.</translation>
    </message>
    <message>
        <source>The row and column directions are {error:.4f} off perpendicular unit vectors, and were set right.</source>
        <translation>Die Richtungen von Zeilen und Spalten weichen um {error:.4f} von senkrechten Einheitsvektoren ab und wurden berichtigt.</translation>
    </message>
    <message>
        <source>The slices are turned against each other by up to {degrees:.3f} degrees; they are drawn with the mean orientation, and a voxel is up to {errorMm:.3f} mm away from where it is drawn.</source>
        <translation>Die Schichten sind um bis zu {degrees:.3f} Grad gegeneinander gedreht; sie werden mit der mittleren Lage gezeichnet, und ein Voxel liegt bis zu {errorMm:.3f} mm neben der Stelle, an der es gezeichnet ist.</translation>
    </message>
    <message>
        <source>Allow for this error when measuring.</source>
        <translation>Rechnen Sie beim Messen mit diesem Fehler.</translation>
    </message>
    <message>
        <source>Slices that are missing: {missing} of {total}, which are {spacingMm:.3f} mm apart.</source>
        <translation>Fehlende Schichten: {missing} von {total}, die {spacingMm:.3f} mm auseinander liegen.</translation>
    </message>
    <message>
        <source>Slices of the volume that are interpolated, because no image was there: {count} ({slices}).</source>
        <translation>Schichten des Volumens, die interpoliert sind, weil dort kein Bild war: {count} ({slices}).</translation>
    </message>
    <message>
        <source>Do not read anything into interpolated slices.</source>
        <translation>Deuten Sie nichts in interpolierte Schichten hinein.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced, {leastMm:.3f} to {mostMm:.3f} mm apart; they were resampled to an even {spacingMm:.3f} mm.</source>
        <translation>Die Schichten haben ungleiche Abstände von {leastMm:.3f} bis {mostMm:.3f} mm; sie wurden auf gleichmäßige {spacingMm:.3f} mm umgerechnet.</translation>
    </message>
    <message>
        <source>Look at the original images before measuring across slices.</source>
        <translation>Sehen Sie die Originalbilder an, bevor Sie über Schichten hinweg messen.</translation>
    </message>
    <message>
        <source>The slices are too unevenly spaced for a volume, {leastMm:.3f} to {mostMm:.3f} mm apart.</source>
        <translation>Die Schichten haben für ein Volumen zu ungleiche Abstände, {leastMm:.3f} bis {mostMm:.3f} mm.</translation>
    </message>
    <message>
        <source>Images whose position is missing or cannot be right, and that were left out of the volume: {numbers}.</source>
        <translation>Bilder, deren Position fehlt oder nicht stimmen kann und die im Volumen fehlen: {numbers}.</translation>
    </message>
    <message>
        <source>The slices are not quite evenly spaced: a slice is up to {errorMm:.3f} mm away from where it is drawn.</source>
        <translation>Die Schichtabstände sind nicht ganz gleich: eine Schicht liegt bis zu {errorMm:.3f} mm neben ihrem gezeigten Ort.</translation>
    </message>
    <message>
        <source>Allow for this error when measuring across slices.</source>
        <translation>Berücksichtigen Sie diesen Fehler beim Messen über Schichten hinweg.</translation>
    </message>
    <message>
        <source>The images are not parallel to each other.</source>
        <translation>Die Bilder sind nicht parallel zueinander.</translation>
    </message>
    <message>
        <source>The images do not make a volume: {reason}.</source>
        <translation>Die Bilder ergeben kein Volumen: {reason}.</translation>
    </message>
    <message>
        <source>The slices are stacked at an angle of {degrees:.1f} degrees (tilted gantry), and are drawn so.</source>
        <translation>Die Schichten sind unter einem Winkel von {degrees:.1f} Grad gestapelt (geneigte Gantry) und werden so gezeigt.</translation>
    </message>
    <message>
        <source>The slices are {thicknessMm:.2f} mm thick and {spacingMm:.2f} mm apart: {percent:.0f} % of what is between the first and the last was never imaged, and is interpolated here.</source>
        <translation>Die Schichten sind {thicknessMm:.2f} mm dick und {spacingMm:.2f} mm auseinander: {percent:.0f} % zwischen der ersten und der letzten wurde nie aufgenommen und ist hier interpoliert.</translation>
    </message>
    <message>
        <source>Do not read anything into what lies between the slices.</source>
        <translation>Deuten Sie nichts in das hinein, was zwischen den Schichten liegt.</translation>
    </message>
    <message>
        <source>Images of this kind ({kind}) are no slices of a volume.</source>
        <translation>Bilder dieser Art ({kind}) sind keine Schichten eines Volumens.</translation>
    </message>
    <message>
        <source>The images are in colour; a volume needs one value per voxel.</source>
        <translation>Die Bilder sind farbig; ein Volumen braucht einen Wert je Voxel.</translation>
    </message>
    <message>
        <source>The images do not say in a usable way which bits of a pixel hold its value: neither whole numbers in 1, 8, 16 or 32 bits nor floating point.</source>
        <translation>Die Bilder sagen nicht auf brauchbare Weise, welche Bits eines Pixels seinen Wert enthalten: weder ganze Zahlen in 1, 8, 16 oder 32 Bit noch Gleitkommazahlen.</translation>
    </message>
    <message>
        <source>This version cannot decode the images: {syntax}.</source>
        <translation>Diese Version kann die Bilder nicht dekodieren: {syntax}.</translation>
    </message>
    <message>
        <source>Images whose pixels this version cannot decode, and that were left out of the volume: {numbers}.</source>
        <translation>Bilder, deren Pixel diese Version nicht dekodieren kann und die im Volumen fehlen: {numbers}.</translation>
    </message>
    <message>
        <source>The images say that their pixels are encoded as {said}, and they are as {found}, which they were read as.</source>
        <translation>Die Bilder geben an, ihre Pixel seien als {said} codiert; sie sind es als {found} und wurden so gelesen.</translation>
    </message>
    <message>
        <source>Have the images exported again; other programs may not read them.</source>
        <translation>Lassen Sie die Bilder neu exportieren; andere Programme lesen sie vielleicht nicht.</translation>
    </message>
    <message>
        <source>The images do not say how a value is shown; greater ones were taken as brighter.</source>
        <translation>Die Bilder sagen nicht, wie ein Wert gezeigt wird; größere wurden als heller angenommen.</translation>
    </message>
    <message>
        <source>Each image is a mosaic of many slices (Siemens), which this version does not unpack.</source>
        <translation>Jedes Bild ist ein Mosaik vieler Schichten (Siemens), das diese Version nicht zerlegt.</translation>
    </message>
    <message>
        <source>Export the series again as one image for each slice, or convert it with dcm2niix.</source>
        <translation>Exportieren Sie die Serie noch einmal mit einem Bild je Schicht, oder wandeln Sie sie mit dcm2niix um.</translation>
    </message>
    <message>
        <source>These values are a dose distribution (unit: {unit}), and no anatomy.</source>
        <translation>Diese Werte sind eine Dosisverteilung (Einheit: {unit}) und keine Anatomie.</translation>
    </message>
    <message>
        <source>To see anatomy, choose the images that the treatment was planned on.</source>
        <translation>Um Anatomie zu sehen, wählen Sie die Bilder, auf denen die Behandlung geplant wurde.</translation>
    </message>
    <message>
        <source>The values come from a lookup table in the images, which was applied.</source>
        <translation>Die Werte kommen aus einer Tabelle in den Bildern, die angewendet wurde.</translation>
    </message>
    <message>
        <source>The lookup table that makes values of the pixels is not a usable one.</source>
        <translation>Die Tabelle, die aus Pixeln Werte macht, ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>The rescale slope or intercept of an image is not a usable number.</source>
        <translation>Rescale Slope oder Intercept eines Bildes ist keine brauchbare Zahl.</translation>
    </message>
    <message>
        <source>Images that do not say how stored numbers become values: {count} of {total}. A missing rescale slope was taken as 1, a missing intercept as 0.</source>
        <translation>Bilder, die nicht sagen, wie aus gespeicherten Zahlen Werte werden: {count} von {total}. Ein fehlender Rescale Slope wurde als 1, ein fehlender Intercept als 0 angenommen.</translation>
    </message>
    <message>
        <source>Do not rely on the values; presets made for Hounsfield units may not fit.</source>
        <translation>Verlassen Sie sich nicht auf die Werte; Voreinstellungen für Hounsfield-Einheiten passen vielleicht nicht.</translation>
    </message>
    <message>
        <source>These CT images do not say that their values are Hounsfield units ({reason}); they are taken as plain numbers.</source>
        <translation>Diese CT-Bilder sagen nicht, dass ihre Werte Hounsfield-Einheiten sind ({reason}); sie gelten als einfache Zahlen.</translation>
    </message>
    <message>
        <source>Presets for Hounsfield units do not fit, and the table cannot be removed. Use the original images.</source>
        <translation>Voreinstellungen für Hounsfield-Einheiten passen nicht, und der Tisch kann nicht entfernt werden. Verwenden Sie die Originalbilder.</translation>
    </message>
    <message>
        <source>Images whose rescale slope or intercept is missing or cannot be right, and that were left out of the volume: {numbers}.</source>
        <translation>Bilder, deren Rescale Slope oder Intercept fehlt oder nicht stimmen kann und die im Volumen fehlen: {numbers}.</translation>
    </message>
    <message>
        <source>Images whose rescale slope or intercept is another than that of all others; it was applied as it is: {numbers}.</source>
        <translation>Bilder, deren Rescale Slope oder Intercept ein anderer ist als bei allen übrigen; er wurde so angewendet: {numbers}.</translation>
    </message>
    <message>
        <source>Compare these slices with their neighbours; if they are brighter or darker, copy the series again from its source.</source>
        <translation>Vergleichen Sie diese Schichten mit ihren Nachbarn; sind sie heller oder dunkler, kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>Each image has its own rescale factors; they are applied image by image.</source>
        <translation>Jedes Bild hat eigene Rescale-Faktoren; sie werden Bild für Bild angewendet.</translation>
    </message>
    <message>
        <source>Places where the values jump because the rescale slope or intercept changes and the stored numbers do not: {count}, first at slice {slice}, by {step:.4g}. The values on one side are wrong.</source>
        <translation>Stellen, an denen die Werte springen, weil sich Rescale Slope oder Intercept ändert und die gespeicherten Zahlen nicht: {count}, zuerst bei Schicht {slice}, um {step:.4g}. Die Werte auf einer Seite sind falsch.</translation>
    </message>
    <message>
        <source>Do not rely on values of this volume; export the series again.</source>
        <translation>Verlassen Sie sich nicht auf Werte dieses Volumens; exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>Images whose pixels {fault}, and that were left out of the volume: {numbers}.</source>
        <translation>Bilder, deren Pixel {fault} und die im Volumen fehlen: {numbers}.</translation>
    </message>
    <message>
        <source>Images whose pixels {fault}: {count} of {total}. They are shown as the images say.</source>
        <translation>Bilder, deren Pixel {fault}: {count} von {total}. Sie werden gezeigt, wie die Bilder es angeben.</translation>
    </message>
    <message>
        <source>Do not rely on the values; export the series again.</source>
        <translation>Verlassen Sie sich nicht auf die Werte; exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>Images that differ from both of their neighbours far more than these from each other; they are shown as they are: {numbers}.</source>
        <translation>Bilder, die von beiden Nachbarn weit mehr abweichen als diese voneinander; sie werden gezeigt, wie sie sind: {numbers}.</translation>
    </message>
    <message>
        <source>Compare these slices with their neighbours, and copy the series again from its source.</source>
        <translation>Vergleichen Sie diese Schichten mit ihren Nachbarn, und kopieren Sie die Serie noch einmal von ihrer Quelle.</translation>
    </message>
    <message>
        <source>The values are the real world values that the images define, in {unit}.</source>
        <translation>Die Werte sind die Real World Values, die die Bilder festlegen, in {unit}.</translation>
    </message>
    <message>
        <source>Standardised uptake values cannot be worked out: {missing} is missing or not usable.</source>
        <translation>Standardisierte Aufnahmewerte (SUV) können nicht berechnet werden: {missing} fehlt oder ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Images whose values need more bits than they say, and that were left out of the volume: {numbers}.</source>
        <translation>Bilder, deren Werte mehr Bits brauchen, als sie angeben, und die im Volumen fehlen: {numbers}.</translation>
    </message>
    <message>
        <source>Images with bits outside of those that they say hold the values: {count} of {total}. These bits were dropped.</source>
        <translation>Bilder mit Bits außerhalb derer, die laut Angabe die Werte enthalten: {count} von {total}. Diese Bits wurden weggelassen.</translation>
    </message>
    <message>
        <source>Compare the values with those that another program shows.</source>
        <translation>Vergleichen Sie die Werte mit denen, die ein anderes Programm zeigt.</translation>
    </message>
    <message>
        <source>Images that say that their values lie higher in a pixel (HighBit) than the bits in use: {count} of {total}. They were read from the lowest bit on; as the images say, values would be a fraction of these.</source>
        <translation>Bilder, die angeben, ihre Werte lägen höher im Pixel (HighBit) als die benutzten Bits: {count} von {total}. Sie wurden vom niedrigsten Bit an gelesen; nach den Angaben wären die Werte ein Bruchteil davon.</translation>
    </message>
    <message>
        <source>Pixels that are no finite number: {count}. They are treated as outside of the scan.</source>
        <translation>Pixel, die keine endliche Zahl sind: {count}. Sie gelten als außerhalb der Aufnahme.</translation>
    </message>
    <message>
        <source>Do not read anything into the places where they are.</source>
        <translation>Deuten Sie nichts in die Stellen hinein, an denen sie sind.</translation>
    </message>
    <message>
        <source>The images were compressed with loss; fine detail may be missing or false.</source>
        <translation>Die Bilder wurden verlustbehaftet komprimiert; feine Einzelheiten können fehlen oder falsch sein.</translation>
    </message>
    <message>
        <source>Use the original images for diagnosis.</source>
        <translation>Verwenden Sie zur Diagnose die Originalbilder.</translation>
    </message>
    <message>
        <source>The images have lookup tables that say how they are shown (VOI LUT); these are not used, only windows are.</source>
        <translation>Die Bilder haben Tabellen, die sagen, wie sie gezeigt werden (VOI LUT); diese werden nicht verwendet, nur Fenster.</translation>
    </message>
    <message>
        <source>The images are meant to be shown with low values bright (MONOCHROME1); values are as stored.</source>
        <translation>Die Bilder sind dafür gedacht, niedrige Werte hell zu zeigen (MONOCHROME1); Werte sind wie gespeichert.</translation>
    </message>
    <message>
        <source>The display window of these images is not usable, and was ignored.</source>
        <translation>Die Fensterung dieser Bilder ist nicht brauchbar und wurde nicht beachtet.</translation>
    </message>
    <message>
        <source>{count} voxels belong to several segments; of each only the last is shown.</source>
        <translation>{count} Voxel gehören zu mehreren Segmenten; von jedem wird nur das letzte gezeigt.</translation>
    </message>
    <message>
        <source>Look at the segments one by one in the program that made them.</source>
        <translation>Sehen Sie die Segmente einzeln in dem Programm an, das sie erstellt hat.</translation>
    </message>
    <message>
        <source>{count} voxels of the segmentation lie outside of the volume, and are not shown.</source>
        <translation>{count} Voxel der Segmentierung liegen außerhalb des Volumens und werden nicht gezeigt.</translation>
    </message>
    <message>
        <source>Check that no slices of the series are missing.</source>
        <translation>Prüfen Sie, ob Schichten der Serie fehlen.</translation>
    </message>
    <message>
        <source>Segment {number} has the number of the background (Pixel Padding Value): nothing of it is shown.</source>
        <translation>Segment {number} hat die Nummer des Hintergrunds (Pixel Padding Value): nichts davon wird gezeigt.</translation>
    </message>
    <message>
        <source>Look at it in the program that made it.</source>
        <translation>Sehen Sie es in dem Programm an, das es erstellt hat.</translation>
    </message>
    <message>
        <source>Segment 0 has the number {number} in the label map, in which 0 is none of the segments.</source>
        <translation>Segment 0 hat in der Label-Map die Nummer {number}, denn dort ist 0 keines der Segmente.</translation>
    </message>
    <message>
        <source>Presentation states: {count}; they are no images, and say how a series is shown.</source>
        <translation>Presentation States: {count}; sie sind keine Bilder und sagen, wie eine Serie gezeigt wird.</translation>
    </message>
    <message>
        <source>Open one of them in the list of studies; macula render draws those of 3D views.</source>
        <translation>Öffnen Sie einen davon in der Liste der Studien; macula render zeichnet die von 3D-Ansichten.</translation>
    </message>
    <message>
        <source>The presentation state has {what}, which cannot be shown.</source>
        <translation>Der Presentation State enthält {what}; das kann nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>Compare with what the program shows that made it.</source>
        <translation>Vergleichen Sie mit dem, was das Programm zeigt, das ihn erstellt hat.</translation>
    </message>
    <message>
        <source>The presentation state has {what}; {how}.</source>
        <translation>Der Presentation State enthält {what}; {how}.</translation>
    </message>
    <message>
        <source>Another program changed this presentation state of Macula; it is shown as its standard attributes say.</source>
        <translation>Ein anderes Programm hat diesen Presentation State von Macula geändert; er wird gezeigt, wie es seine Standardattribute angeben.</translation>
    </message>
    <message>
        <source>The table is left out, and whatever else lies apart from the patient: {partsText}, {volumeText} (confidence {confidence}).</source>
        <translation>Der Tisch und was sonst abseits des Patienten liegt, ist weggelassen: {partsText}, {volumeText} (Sicherheit: {confidence}).</translation>
    </message>
    <message>
        <source>Show the table again to see everything that was scanned.</source>
        <translation>Zeigen Sie den Tisch wieder, um alles Aufgenommene zu sehen.</translation>
    </message>
    <message>
        <source>No table was found. What lies apart from the patient is left out: {partsText}, {volumeText} (confidence {confidence}).</source>
        <translation>Kein Tisch wurde gefunden. Was abseits des Patienten liegt, ist weggelassen: {partsText}, {volumeText} (Sicherheit: {confidence}).</translation>
    </message>
    <message>
        <source>Nothing lies apart from the patient; nothing is left out.</source>
        <translation>Nichts liegt abseits des Patienten; nichts ist weggelassen.</translation>
    </message>
    <message>
        <source>The patient lies against the table in {slices} of {total} slices of the search grid; the surface between them is an estimate there, to about 3 mm.</source>
        <translation>Der Patient liegt in {slices} von {total} Schichten des Suchgitters am Tisch an; die Fläche dazwischen ist dort auf etwa 3 mm geschätzt.</translation>
    </message>
    <message>
        <source>Do not judge the skin of the side that the patient lies on; show the table again for that.</source>
        <translation>Beurteilen Sie die Haut der Seite nicht, auf der der Patient liegt; zeigen Sie dafür den Tisch wieder.</translation>
    </message>
    <message>
        <source>It is not clear what is patient and what is table; nothing is left out.</source>
        <translation>Es ist nicht klar, was Patient und was Tisch ist; nichts ist weggelassen.</translation>
    </message>
    <message>
        <source>Cut the table away with a clip plane or box.</source>
        <translation>Schneiden Sie den Tisch mit einer Schnittebene oder einem Quader weg.</translation>
    </message>
    <message>
        <source>No patient was found in these images; nothing is left out.</source>
        <translation>In diesen Bildern wurde kein Patient gefunden; nichts ist weggelassen.</translation>
    </message>
    <message>
        <source>Computed radiography image</source>
        <translation>Speicherfolienaufnahme (CR)</translation>
    </message>
    <message>
        <source>Digital X-ray image</source>
        <translation>digitale Röntgenaufnahme</translation>
    </message>
    <message>
        <source>Digital X-ray image, unprocessed</source>
        <translation>digitale Röntgenaufnahme, unverarbeitet</translation>
    </message>
    <message>
        <source>Mammography image</source>
        <translation>Mammographie</translation>
    </message>
    <message>
        <source>Mammography image, unprocessed</source>
        <translation>Mammographie, unverarbeitet</translation>
    </message>
    <message>
        <source>Intra-oral X-ray image</source>
        <translation>intraorale Röntgenaufnahme</translation>
    </message>
    <message>
        <source>X-ray angiographic image</source>
        <translation>angiographische Röntgenaufnahme</translation>
    </message>
    <message>
        <source>Enhanced X-ray angiographic image</source>
        <translation>angiographische Röntgenaufnahme (Enhanced)</translation>
    </message>
    <message>
        <source>X-ray radiofluoroscopic image</source>
        <translation>Durchleuchtung</translation>
    </message>
    <message>
        <source>Enhanced X-ray radiofluoroscopic image</source>
        <translation>Durchleuchtung (Enhanced)</translation>
    </message>
    <message>
        <source>Visible light image</source>
        <translation>Aufnahme in sichtbarem Licht</translation>
    </message>
    <message>
        <source>Ultrasound clip</source>
        <translation>Ultraschallsequenz</translation>
    </message>
    <message>
        <source>Ultrasound image</source>
        <translation>Ultraschallbild</translation>
    </message>
    <message>
        <source>Key object selection</source>
        <translation>Auswahl wichtiger Bilder (Key Object Selection)</translation>
    </message>
    <message>
        <source>Structured report</source>
        <translation>strukturierter Befund (Structured Report)</translation>
    </message>
    <message>
        <source>Presentation state of slices</source>
        <translation>Presentation State von Schichten</translation>
    </message>
    <message>
        <source>Presentation state of a 3D view</source>
        <translation>Presentation State einer 3D-Ansicht</translation>
    </message>
    <message>
        <source>Presentation state</source>
        <translation>Presentation State</translation>
    </message>
    <message>
        <source>Waveform</source>
        <translation>Kurve (Waveform)</translation>
    </message>
    <message>
        <source>Raw data</source>
        <translation>Rohdaten</translation>
    </message>
    <message>
        <source>Spatial registration</source>
        <translation>räumliche Registrierung</translation>
    </message>
    <message>
        <source>Spatial fiducials</source>
        <translation>räumliche Marker</translation>
    </message>
    <message>
        <source>Deformable spatial registration</source>
        <translation>elastische räumliche Registrierung</translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation>Segmentierung</translation>
    </message>
    <message>
        <source>Surface segmentation</source>
        <translation>Oberflächensegmentierung</translation>
    </message>
    <message>
        <source>Tractography</source>
        <translation>Traktographie</translation>
    </message>
    <message>
        <source>Label map segmentation</source>
        <translation>Label-Map-Segmentierung</translation>
    </message>
    <message>
        <source>Real world value mapping</source>
        <translation>Zuordnung von Real World Values</translation>
    </message>
    <message>
        <source>MR spectroscopy</source>
        <translation>MR-Spektroskopie</translation>
    </message>
    <message>
        <source>PDF document</source>
        <translation>PDF-Dokument</translation>
    </message>
    <message>
        <source>CDA document</source>
        <translation>CDA-Dokument</translation>
    </message>
    <message>
        <source>Document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>Radiotherapy structure set</source>
        <translation>Strahlentherapie-Strukturen (RTSTRUCT)</translation>
    </message>
    <message>
        <source>Radiotherapy plan</source>
        <translation>Bestrahlungsplan</translation>
    </message>
    <message>
        <source>Radiotherapy object</source>
        <translation>Strahlentherapie-Objekt</translation>
    </message>
    <message>
        <source>Left drag, arrows</source>
        <translation>Links ziehen, Pfeile</translation>
    </message>
    <message>
        <source>Walk around the patient</source>
        <translation>Um den Patienten herumgehen</translation>
    </message>
    <message>
        <source>Middle drag, Shift + left drag, Shift + arrows</source>
        <translation>Mitte ziehen, Umschalt + links ziehen, Umschalt + Pfeile</translation>
    </message>
    <message>
        <source>Move sideways</source>
        <translation>Seitwärts verschieben</translation>
    </message>
    <message>
        <source>Wheel, right drag, Ctrl + left drag, + and -</source>
        <translation>Rad, rechts ziehen, Strg + links ziehen, + und -</translation>
    </message>
    <message>
        <source>Closer, farther</source>
        <translation>Näher, weiter weg</translation>
    </message>
    <message>
        <source>Alt + left drag, Ctrl + Left and Right, [ and ]</source>
        <translation>Alt + links ziehen, Strg + Links und Rechts, [ und ]</translation>
    </message>
    <message>
        <source>Turn the picture: clockwise to the right</source>
        <translation>Bild drehen: nach rechts im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Alt + wheel</source>
        <translation>Alt + Rad</translation>
    </message>
    <message>
        <source>Fly in: the camera and what it turns around go forward</source>
        <translation>Hineinfliegen: Kamera und Drehpunkt gehen vorwärts</translation>
    </message>
    <message>
        <source>Right drag in maximum, minimum, average</source>
        <translation>Rechts ziehen in Maximum, Minimum, Mittelwert</translation>
    </message>
    <message>
        <source>Window: wider to the right, brighter up</source>
        <translation>Fensterung: nach rechts breiter, nach oben heller</translation>
    </message>
    <message>
        <source>Alt + right drag, or drag with T held</source>
        <translation>Alt + rechts ziehen, oder ziehen mit gehaltenem T</translation>
    </message>
    <message>
        <source>Transfer function: shift to the right, widen upwards</source>
        <translation>Übertragungsfunktion: nach rechts verschieben, nach oben verbreitern</translation>
    </message>
    <message>
        <source>Double click in 3D</source>
        <translation>Doppelklick in 3D</translation>
    </message>
    <message>
        <source>Turn around what is there, and show it on slices</source>
        <translation>Um das drehen, was dort ist, und es auf Schichten zeigen</translation>
    </message>
    <message>
        <source>Window of the series again</source>
        <translation>Wieder die Fensterung der Serie</translation>
    </message>
    <message>
        <source>Look from anterior</source>
        <translation>Ansicht von anterior</translation>
    </message>
    <message>
        <source>Look from posterior</source>
        <translation>Ansicht von posterior</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s left</source>
        <translation>Ansicht von links des Patienten</translation>
    </message>
    <message>
        <source>Look from the patient&apos;s right</source>
        <translation>Ansicht von rechts des Patienten</translation>
    </message>
    <message>
        <source>Look from superior</source>
        <translation>Ansicht von superior</translation>
    </message>
    <message>
        <source>Look from inferior</source>
        <translation>Ansicht von inferior</translation>
    </message>
    <message>
        <source>Fit what is visible</source>
        <translation>Sichtbares einpassen</translation>
    </message>
    <message>
        <source>Parallel rays, or seen by an eye</source>
        <translation>Parallele Strahlen, oder wie mit einem Auge gesehen</translation>
    </message>
    <message>
        <source>Patient, study and series over the picture, in title and lists, or not</source>
        <translation>Patient, Studie und Serie über dem Bild, in Titel und Listen, oder nicht</translation>
    </message>
    <message>
        <source>Cube and scale, or not</source>
        <translation>Würfel und Maßstab, oder nicht</translation>
    </message>
    <message>
        <source>Click on a side of the cube</source>
        <translation>Klick auf eine Seite des Würfels</translation>
    </message>
    <message>
        <source>Look from there, as near as before</source>
        <translation>Ansicht von dort, so nah wie vorher</translation>
    </message>
    <message>
        <source>Ctrl+1 to Ctrl+6</source>
        <translation>Strg+1 bis Strg+6</translation>
    </message>
    <message>
        <source>Cinematic, clear, ray cast, maximum, minimum, average</source>
        <translation>Cinematic, Klar, Volumen-Rendering, Maximum, Minimum, Mittelwert</translation>
    </message>
    <message>
        <source>Shade the ray cast, or not</source>
        <translation>Volumen-Rendering schattieren, oder nicht</translation>
    </message>
    <message>
        <source>Remove the table of a CT, or show it again</source>
        <translation>Den Tisch eines CT entfernen oder wieder zeigen</translation>
    </message>
    <message>
        <source>No clip</source>
        <translation>Kein Beschnitt</translation>
    </message>
    <message>
        <source>Handles of the clip in all pictures, or not</source>
        <translation>Griffe des Beschnitts in allen Bildern, oder nicht</translation>
    </message>
    <message>
        <source>Shift + wheel in 3D with handles</source>
        <translation>Umschalt + Rad in 3D mit Griffen</translation>
    </message>
    <message>
        <source>Cut across the line of sight: deeper, less deep</source>
        <translation>Schnitt quer zur Blickrichtung: tiefer, weniger tief</translation>
    </message>
    <message>
        <source>Drag a handle, Shift + wheel in 3D with the panel of lights</source>
        <translation>Griff ziehen, Umschalt + Mausrad in 3D mit der Leiste der Lichter</translation>
    </message>
    <message>
        <source>Where a light shines from, how strong it is</source>
        <translation>Woher ein Licht scheint, wie stark es ist</translation>
    </message>
    <message>
        <source>Scissors: draw around what is to go in 3D; with Shift, what stays; or not</source>
        <translation>Schere: in 3D umfahren, was weg soll; mit Umschalt, was bleibt; oder nicht</translation>
    </message>
    <message>
        <source>Drop a folder or a file</source>
        <translation>Ordner oder Datei ablegen</translation>
    </message>
    <message>
        <source>Open a study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Open an image or a volume file</source>
        <translation>Bild oder Volumendatei öffnen</translation>
    </message>
    <message>
        <source>Open a prior or another volume beside the study</source>
        <translation>Voraufnahme oder anderes Volumen neben der Studie öffnen</translation>
    </message>
    <message>
        <source>Ctrl+Tab</source>
        <translation>Strg+Tab</translation>
    </message>
    <message>
        <source>The second volume in the place of the study, and back</source>
        <translation>Das zweite Volumen an Stelle der Studie, und zurück</translation>
    </message>
    <message>
        <source>Save the view: all that was chosen, and the camera</source>
        <translation>Ansicht speichern: alles, was gewählt wurde, und die Kamera</translation>
    </message>
    <message>
        <source>Open a view that was saved</source>
        <translation>Gespeicherte Ansicht öffnen</translation>
    </message>
    <message>
        <source>Save the picture, at any size</source>
        <translation>Bild speichern, in jeder Größe</translation>
    </message>
    <message>
        <source>Save the measurements as a table</source>
        <translation>Messungen als Tabelle speichern</translation>
    </message>
    <message>
        <source>Save the 3D view as a DICOM presentation state</source>
        <translation>3D-Ansicht als DICOM Presentation State speichern</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Letzte Änderung rückgängig</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>F5 to F9</source>
        <translation>F5 bis F9</translation>
    </message>
    <message>
        <source>Four panes, or 3D, axial, coronal, sagittal alone</source>
        <translation>Vier Bildfelder, oder 3D, axial, koronar, sagittal allein</translation>
    </message>
    <message>
        <source>F2 to F4, F10, F12</source>
        <translation>F2 bis F4, F10, F12</translation>
    </message>
    <message>
        <source>Panels: studies, transfer function, clip; presets; lights</source>
        <translation>Leisten: Studien, Übertragungsfunktion, Beschnitt; Voreinstellungen; Lichter</translation>
    </message>
    <message>
        <source>Panel: segmentations</source>
        <translation>Leiste: Segmentierungen</translation>
    </message>
    <message>
        <source>Find a study of the folder</source>
        <translation>Studie des Ordners suchen</translation>
    </message>
    <message>
        <source>Wheel, Up, Down on slices</source>
        <translation>Rad, Auf, Ab auf Schichten</translation>
    </message>
    <message>
        <source>Next slice; with Shift, or Page Up and Page Down, five; Home and End: to the ends</source>
        <translation>Nächste Schicht; mit Umschalt oder Bild auf und Bild ab fünf; Pos1 und Ende: zu den Enden</translation>
    </message>
    <message>
        <source>Right drag, 1 to 9 on slices</source>
        <translation>Rechts ziehen, 1 bis 9 auf Schichten</translation>
    </message>
    <message>
        <source>Window: wider to the right, brighter up; or a customary one</source>
        <translation>Fensterung: nach rechts breiter, nach oben heller; oder eine übliche</translation>
    </message>
    <message>
        <source>Ctrl + wheel, middle drag, +, - on slices</source>
        <translation>Strg + Rad, Mitte ziehen, +, - auf Schichten</translation>
    </message>
    <message>
        <source>Closer, sideways</source>
        <translation>Näher, seitwärts</translation>
    </message>
    <message>
        <source>F, double right click on slices</source>
        <translation>F, Doppelklick rechts auf Schichten</translation>
    </message>
    <message>
        <source>The whole slice, in the middle of its pane</source>
        <translation>Die ganze Schicht, in der Mitte ihres Bildfelds</translation>
    </message>
    <message>
        <source>Tab, Shift + Tab</source>
        <translation>Tab, Umschalt + Tab</translation>
    </message>
    <message>
        <source>To the next pane or control, or back</source>
        <translation>Zum nächsten Bildfeld oder Bedienelement, oder zurück</translation>
    </message>
    <message>
        <source>I on slices</source>
        <translation>I auf Schichten</translation>
    </message>
    <message>
        <source>White and black change places</source>
        <translation>Weiß und Schwarz tauschen den Platz</translation>
    </message>
    <message>
        <source>Space on slices</source>
        <translation>Leertaste auf Schichten</translation>
    </message>
    <message>
        <source>Play through all slices, or stop</source>
        <translation>Alle Schichten abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Delete on slices</source>
        <translation>Entf auf Schichten</translation>
    </message>
    <message>
        <source>Remove the measurement that is chosen</source>
        <translation>Die gewählte Messung entfernen</translation>
    </message>
    <message>
        <source>Double click on slices</source>
        <translation>Doppelklick auf Schichten</translation>
    </message>
    <message>
        <source>This pane alone, or all four</source>
        <translation>Dieses Bildfeld allein, oder alle vier</translation>
    </message>
    <message>
        <source>Settings: language, look, keys, what is kept</source>
        <translation>Einstellungen: Sprache, Aussehen, Tasten, was aufbewahrt wird</translation>
    </message>
    <message>
        <source>Ctrl+[ and Ctrl+]</source>
        <translation>Strg+[ und Strg+]</translation>
    </message>
    <message>
        <source>Frames in motion: faster, or more accurate</source>
        <translation>Bilder in Bewegung: schneller, oder genauer</translation>
    </message>
    <message>
        <source>Trace the picture at rest until it is final; Esc stops</source>
        <translation>Das ruhende Bild verfolgen, bis es endgültig ist; Esc hält an</translation>
    </message>
    <message>
        <source>Right click, Menu on slices</source>
        <translation>Rechtsklick, Menütaste auf Schichten</translation>
    </message>
    <message>
        <source>Windows, and those of your own</source>
        <translation>Fensterungen, auch eigene</translation>
    </message>
    <message>
        <source>Alt+1 to Alt+9 on slices</source>
        <translation>Alt+1 bis Alt+9 auf Schichten</translation>
    </message>
    <message>
        <source>A window of your own</source>
        <translation>Eine eigene Fensterung</translation>
    </message>
    <message>
        <source>Double click on a measurement, Enter</source>
        <translation>Doppelklick auf eine Messung, Eingabe</translation>
    </message>
    <message>
        <source>Its label</source>
        <translation>Ihre Beschriftung</translation>
    </message>
    <message>
        <source>All keys</source>
        <translation>Alle Tasten</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>&amp;Four Panes</source>
        <translation>&amp;Vier Bildfelder</translation>
    </message>
    <message>
        <source>&amp;3D Alone</source>
        <translation>&amp;3D allein</translation>
    </message>
    <message>
        <source>A&amp;xial Alone</source>
        <translation>A&amp;xial allein</translation>
    </message>
    <message>
        <source>C&amp;oronal Alone</source>
        <translation>K&amp;oronar allein</translation>
    </message>
    <message>
        <source>Sa&amp;gittal Alone</source>
        <translation>Sa&amp;gittal allein</translation>
    </message>
    <message>
        <source>{:.1f} GiB</source>
        <translation>{:.1f} GiB</translation>
    </message>
    <message>
        <source>, and {} are free</source>
        <translation>, und {} sind frei</translation>
    </message>
    <message>
        <source>The camera has a number that is not finite.</source>
        <translation>Die Kamera hat eine Zahl, die nicht endlich ist.</translation>
    </message>
    <message>
        <source>The camera&apos;s vertical field of view must lie between 0.1 and 170 degrees.</source>
        <translation>Das senkrechte Blickfeld der Kamera muss zwischen 0,1 und 170 Grad liegen.</translation>
    </message>
    <message>
        <source>The height of a parallel picture must lie between 0.001 mm and 1 km.</source>
        <translation>Die Höhe eines parallelen Bildes muss zwischen 0,001 mm und 1 km liegen.</translation>
    </message>
    <message>
        <source>The camera&apos;s position and target are the same point.</source>
        <translation>Ort und Ziel der Kamera sind derselbe Punkt.</translation>
    </message>
    <message>
        <source>The camera&apos;s up direction is parallel to its view.</source>
        <translation>Die Richtung nach oben der Kamera ist parallel zu ihrem Blick.</translation>
    </message>
    <message>
        <source>The segmentation has no voxels.</source>
        <translation>Die Segmentierung hat keine Voxel.</translation>
    </message>
    <message>
        <source>The segmentation has not as many voxels as its size says.</source>
        <translation>Die Segmentierung hat nicht so viele Voxel, wie ihre Größe angibt.</translation>
    </message>
    <message>
        <source>The segmentation does not say where it lies.</source>
        <translation>Die Segmentierung sagt nicht, wo sie liegt.</translation>
    </message>
    <message>
        <source>The volume should have {} voxels, and has {}.</source>
        <translation>Das Volumen sollte {} Voxel haben und hat {}.</translation>
    </message>
    <message>
        <source>The position of the voxels in the patient is not usable: the axes do not span a volume.</source>
        <translation>Die Lage der Voxel im Patienten ist nicht brauchbar: die Achsen spannen kein Volumen auf.</translation>
    </message>
    <message>
        <source>another unit</source>
        <translation>eine andere Einheit</translation>
    </message>
    <message>
        <source>× reference dose</source>
        <translation>× Referenzdosis</translation>
    </message>
    <message>
        <source>The only volume{}.</source>
        <translation>Das einzige Volumen{}.</translation>
    </message>
    <message>
        <source>Its series has {} other stack of images.</source>
        <translation>Ihre Serie hat {} weiteren Bildstapel.</translation>
    </message>
    <message>
        <source>Its series has {} other stacks of images.</source>
        <translation>Ihre Serie hat {} weitere Bildstapel.</translation>
    </message>
    <message>
        <source>Nothing{} can be shown in 3D. {}: {}</source>
        <translation>Nichts{} kann in 3D gezeigt werden. {}: {}</translation>
    </message>
    <message>
        <source>The only stack of images</source>
        <translation>Der einzige Bildstapel</translation>
    </message>
    <message>
        <source>The largest of {} stacks of images</source>
        <translation>Der größte von {} Bildstapeln</translation>
    </message>
    <message>
        <source>it is no volume.</source>
        <translation>es ist kein Volumen.</translation>
    </message>
    <message>
        <source>There are no images{}.</source>
        <translation>Es gibt keine Bilder{}.</translation>
    </message>
    <message>
        <source>Of {} volumes{} the {}one {}with the most voxels ({} x {} x {}).</source>
        <translation>Von {} Volumen{} das {}{}mit den meisten Voxeln ({} x {} x {}).</translation>
    </message>
    <message>
        <source>original axial </source>
        <translation>originale axiale </translation>
    </message>
    <message>
        <source>original </source>
        <translation>originale </translation>
    </message>
    <message>
        <source>without interpolated slices and </source>
        <translation>ohne interpolierte Schichten und </translation>
    </message>
    <message>
        <source> of {} in this folder</source>
        <translation> von {} in diesem Ordner</translation>
    </message>
    <message>
        <source> in this series</source>
        <translation> in dieser Serie</translation>
    </message>
    <message>
        <source>decode the image</source>
        <translation>das Bild zu dekodieren</translation>
    </message>
    <message>
        <source>{} of the {} images cannot be decoded. {}</source>
        <translation>{} der {} Bilder können nicht dekodiert werden. {}</translation>
    </message>
    <message>
        <source>load this series</source>
        <translation>diese Serie zu laden</translation>
    </message>
    <message>
        <source>have another sign than they say (PixelRepresentation)</source>
        <translation>ein anderes Vorzeichen haben, als sie angeben (PixelRepresentation),</translation>
    </message>
    <message>
        <source>have their bytes in the wrong order</source>
        <translation>ihre Bytes in falscher Reihenfolge haben</translation>
    </message>
    <message>
        <source>have one value, in whole or from some row on, between images that go on there</source>
        <translation>ganz oder ab einer Zeile einen einzigen Wert haben, zwischen Bildern, die dort weitergehen,</translation>
    </message>
    <message>
        <source>do not fit</source>
        <translation>nicht passen</translation>
    </message>
    <message>
        <source>several volumes blended into one picture</source>
        <translation>mehrere Volumen, zu einem Bild gemischt</translation>
    </message>
    <message>
        <source>colours of more than one input</source>
        <translation>Farben von mehr als einer Eingabe</translation>
    </message>
    <message>
        <source>more than one input</source>
        <translation>mehr als eine Eingabe</translation>
    </message>
    <message>
        <source>more than one set of images</source>
        <translation>mehr als einen Satz von Bildern</translation>
    </message>
    <message>
        <source>a registration to another frame of reference</source>
        <translation>eine Registrierung auf ein anderes Koordinatensystem</translation>
    </message>
    <message>
        <source>a sequence of volumes in time</source>
        <translation>eine zeitliche Folge von Volumen</translation>
    </message>
    <message>
        <source>an unreadable list of frames</source>
        <translation>eine unlesbare Liste von Einzelbildern</translation>
    </message>
    <message>
        <source>a window that is no straight line</source>
        <translation>eine Fensterung, die keine gerade Linie ist</translation>
    </message>
    <message>
        <source>a straight one is shown</source>
        <translation>eine gerade wird gezeigt</translation>
    </message>
    <message>
        <source>colours of another space</source>
        <translation>Farben eines anderen Farbraums</translation>
    </message>
    <message>
        <source>they are shown as sRGB</source>
        <translation>sie werden als sRGB gezeigt</translation>
    </message>
    <message>
        <source>a clip by a segmentation</source>
        <translation>einen Beschnitt durch eine Segmentierung</translation>
    </message>
    <message>
        <source>shading with numbers that are not 0 to 1</source>
        <translation>eine Schattierung mit Zahlen, die nicht 0 bis 1 sind</translation>
    </message>
    <message>
        <source>an animation</source>
        <translation>eine Animation</translation>
    </message>
    <message>
        <source>drawings or texts over the picture</source>
        <translation>Zeichnungen oder Texte über dem Bild</translation>
    </message>
    <message>
        <source>Choose a file of the kind Volume Rendering Volumetric Presentation State.</source>
        <translation>Wählen Sie eine Datei der Art Volume Rendering Volumetric Presentation State.</translation>
    </message>
    <message>
        <source>a table of greys</source>
        <translation>eine Tabelle von Grauwerten</translation>
    </message>
    <message>
        <source>a displayed area that is none</source>
        <translation>einen Bildausschnitt, der keiner ist</translation>
    </message>
    <message>
        <source>annotations</source>
        <translation>Anmerkungen</translation>
    </message>
    <message>
        <source>a shutter</source>
        <translation>eine Blende</translation>
    </message>
    <message>
        <source>a subtraction of images</source>
        <translation>eine Subtraktion von Bildern</translation>
    </message>
    <message>
        <source>an overlay</source>
        <translation>ein Overlay</translation>
    </message>
    <message>
        <source>Choose a file of the kind Grayscale Softcopy Presentation State.</source>
        <translation>Wählen Sie eine Datei der Art Grayscale Softcopy Presentation State.</translation>
    </message>
    <message>
        <source>The file is no presentation state of grey slices.</source>
        <translation>Die Datei ist kein Presentation State von grauen Schichten.</translation>
    </message>
    <message>
        <source>read the directory of this disc</source>
        <translation>das Verzeichnis dieses Datenträgers zu lesen</translation>
    </message>
    <message>
        <source>Object of unknown kind</source>
        <translation>Objekt unbekannter Art</translation>
    </message>
    <message>
        <source>Object of class {}</source>
        <translation>Objekt der Klasse {}</translation>
    </message>
    <message>
        <source>unknown compression</source>
        <translation>unbekannte Kompression</translation>
    </message>
    <message>
        <source>no valid identifier</source>
        <translation>keine gültige Kennung</translation>
    </message>
    <message>
        <source>Reading 1 file</source>
        <translation>1 Datei wird gelesen</translation>
    </message>
    <message>
        <source>Reading {} files</source>
        <translation>{} Dateien werden gelesen</translation>
    </message>
    <message>
        <source>read this folder</source>
        <translation>diesen Ordner zu lesen</translation>
    </message>
    <message>
        <source>1 patient</source>
        <translation>1 Patienten</translation>
    </message>
    <message>
        <source>up to {} patients</source>
        <translation>bis zu {} Patienten</translation>
    </message>
    <message>
        <source>{} patients</source>
        <translation>{} Patienten</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>nicht zu öffnen</translation>
    </message>
    <message>
        <source>with a content that is not on this machine</source>
        <translation>mit einem Inhalt, der nicht auf diesem Rechner ist</translation>
    </message>
    <message>
        <source>on a medium that cannot be read there</source>
        <translation>auf einem Medium, das dort nicht gelesen werden kann</translation>
    </message>
    <message>
        <source>with a path that is too long to be opened</source>
        <translation>mit einem Pfad, der zum Öffnen zu lang ist</translation>
    </message>
    <message>
        <source>damaged, or not written as they say</source>
        <translation>beschädigt, oder nicht so geschrieben, wie sie angeben</translation>
    </message>
    <message>
        <source>cut off before the end of their pixel data</source>
        <translation>abgeschnitten vor dem Ende der Pixeldaten</translation>
    </message>
    <message>
        <source>without pixel data</source>
        <translation>ohne Pixeldaten</translation>
    </message>
    <message>
        <source>without a usable number of frames</source>
        <translation>ohne brauchbare Zahl der Einzelbilder</translation>
    </message>
    <message>
        <source>The only DICOM file in this folder cannot be read: {}.</source>
        <translation>Die einzige DICOM-Datei in diesem Ordner kann nicht gelesen werden: {}.</translation>
    </message>
    <message>
        <source>None of the {} DICOM files in this folder can be read: {}.</source>
        <translation>Keine der {} DICOM-Dateien in diesem Ordner kann gelesen werden: {}.</translation>
    </message>
    <message>
        <source>There is the directory of a medium (DICOMDIR) here, and none of the {} files that it lists.</source>
        <translation>Hier ist das Verzeichnis eines Mediums (DICOMDIR), und keine der {} Dateien, die es aufführt.</translation>
    </message>
    <message>
        <source>Copy the whole medium, with all of its folders, and open the copy.</source>
        <translation>Kopieren Sie das ganze Medium mit allen Ordnern, und öffnen Sie die Kopie.</translation>
    </message>
    <message>
        <source>There is no DICOM image in the folder, and some of its sub-folders cannot be read. {}</source>
        <translation>Im Ordner ist kein DICOM-Bild, und manche seiner Unterordner können nicht gelesen werden. {}</translation>
    </message>
    <message>
        <source>There is no DICOM image in the folder itself; links that lead out of it are not followed.</source>
        <translation>Im Ordner selbst ist kein DICOM-Bild; Verknüpfungen, die hinausführen, wird nicht gefolgt.</translation>
    </message>
    <message>
        <source>Choose the folder that the links lead to.</source>
        <translation>Wählen Sie den Ordner, zu dem die Verknüpfungen führen.</translation>
    </message>
    <message>
        <source>There is no DICOM image here but perhaps in an archive ({}), which is not opened.</source>
        <translation>Hier ist kein DICOM-Bild, höchstens in einem Archiv ({}), das nicht geöffnet wird.</translation>
    </message>
    <message>
        <source>There is no file in this folder.</source>
        <translation>In diesem Ordner ist keine Datei.</translation>
    </message>
    <message>
        <source>Choose a folder with DICOM images.</source>
        <translation>Wählen Sie einen Ordner mit DICOM-Bildern.</translation>
    </message>
    <message>
        <source>There is no DICOM image in this folder: the only file in it is none.</source>
        <translation>In diesem Ordner ist kein DICOM-Bild: Seine einzige Datei ist keines.</translation>
    </message>
    <message>
        <source>There is no DICOM image among the {} files of this folder.</source>
        <translation>Unter den {} Dateien dieses Ordners ist kein DICOM-Bild.</translation>
    </message>
    <message>
        <source>load the segmentation</source>
        <translation>die Segmentierung zu laden</translation>
    </message>
    <message>
        <source>read a segmentation</source>
        <translation>eine Segmentierung zu lesen</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} und {}</translation>
    </message>
    <message>
        <source>Series {}</source>
        <translation>Serie {}</translation>
    </message>
    <message>
        <source>Another series</source>
        <translation>Eine andere Serie</translation>
    </message>
    <message>
        <source>The localizer</source>
        <translation>Der Localizer</translation>
    </message>
    <message>
        <source>patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>the image numbers begin at {}</source>
        <translation>die Bildnummern beginnen bei {}</translation>
    </message>
    <message>
        <source>the image numbers leave out {} to {}</source>
        <translation>die Bildnummern lassen {} bis {} aus</translation>
    </message>
    <message>
        <source>the images say that their acquisition has {} (ImagesInAcquisition)</source>
        <translation>die Bilder sagen, dass ihre Aufnahme {} hat (ImagesInAcquisition)</translation>
    </message>
    <message>
        <source>the images say that the series has {} (NumberOfSeriesRelatedInstances)</source>
        <translation>die Bilder sagen, dass die Serie {} hat (NumberOfSeriesRelatedInstances)</translation>
    </message>
    <message>
        <source>the images say that a volume has {} slices (NumberOfSlices)</source>
        <translation>die Bilder sagen, dass ein Volumen {} Schichten hat (NumberOfSlices)</translation>
    </message>
    <message>
        <source>the directory of the medium (DICOMDIR) lists them</source>
        <translation>das Verzeichnis des Mediums (DICOMDIR) führt sie auf</translation>
    </message>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorne</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>their pixel spacings differ</source>
        <translation>ihre Pixelabstände unterscheiden sich</translation>
    </message>
    <message>
        <source>they are shifted sideways against each other</source>
        <translation>sie sind seitlich gegeneinander verschoben</translation>
    </message>
    <message>
        <source>they lie beside each other</source>
        <translation>sie liegen nebeneinander</translation>
    </message>
    <message>
        <source>each is shifted sideways against the one before</source>
        <translation>jedes ist gegen das vorige seitlich verschoben</translation>
    </message>
    <message>
        <source>{} of {} slices declare no padding value; that of the others was taken for them.</source>
        <translation>{} von {} Schichten nennen keinen Füllwert; für sie gilt der der anderen.</translation>
    </message>
    <message>
        <source>without a number</source>
        <translation>ohne Nummer</translation>
    </message>
    <message>
        <source>{}, by their kind of object</source>
        <translation>{}, nach der Art ihrer Objekte</translation>
    </message>
    <message>
        <source>images of an unknown device</source>
        <translation>Bilder eines unbekannten Geräts</translation>
    </message>
    <message>
        <source>what others of the series are</source>
        <translation>das, was andere der Serie sind</translation>
    </message>
    <message>
        <source>{} bytes</source>
        <translation>{} Bytes</translation>
    </message>
    <message>
        <source>{} kB</source>
        <translation>{} kB</translation>
    </message>
    <message>
        <source>{} MB</source>
        <translation>{} MB</translation>
    </message>
    <message>
        <source>their sizes differ</source>
        <translation>ihre Größen unterscheiden sich</translation>
    </message>
    <message>
        <source>they have no pixels</source>
        <translation>sie haben keine Pixel</translation>
    </message>
    <message>
        <source>a unit that is not named</source>
        <translation>einer ungenannten Einheit</translation>
    </message>
    <message>
        <source>not named</source>
        <translation>nicht genannt</translation>
    </message>
    <message>
        <source>a factor that holds for all images</source>
        <translation>einem Faktor, der für alle Bilder gilt</translation>
    </message>
    <message>
        <source>the spacing at the detector</source>
        <translation>dem Abstand am Detektor</translation>
    </message>
    <message>
        <source>the nominal spacing of the scanned film</source>
        <translation>dem Nennabstand des gescannten Films</translation>
    </message>
    <message>
        <source>SUV by body weight</source>
        <translation>SUV nach Körpergewicht</translation>
    </message>
    <message>
        <source>Units of Bq/mL</source>
        <translation>die Einheit Bq/mL</translation>
    </message>
    <message>
        <source>correction for decay and attenuation</source>
        <translation>die Korrektur für Zerfall und Schwächung</translation>
    </message>
    <message>
        <source>a RadionuclideTotalDose in Bq that fits PatientWeight</source>
        <translation>eine RadionuclideTotalDose in Bq, die zu PatientWeight passt</translation>
    </message>
    <message>
        <source>time of the scan</source>
        <translation>die Aufnahmezeit</translation>
    </message>
    <message>
        <source>plausible time between injection and scan</source>
        <translation>eine plausible Zeit zwischen Injektion und Aufnahme</translation>
    </message>
    <message>
        <source>no rescale slope and intercept</source>
        <translation>kein Rescale Slope und Intercept</translation>
    </message>
    <message>
        <source>their rescale type is another</source>
        <translation>ihr Rescale Type ist ein anderer</translation>
    </message>
    <message>
        <source>their lookup table does not say what it leads to</source>
        <translation>ihre Tabelle sagt nicht, wohin sie führt</translation>
    </message>
    <message>
        <source>no usable description of the pixels</source>
        <translation>keine brauchbare Beschreibung der Pixel</translation>
    </message>
    <message>
        <source>pixels of 8 bits, as of a capture</source>
        <translation>Pixel mit 8 Bit, wie bei einem Capture</translation>
    </message>
    <message>
        <source>they are no CT image objects</source>
        <translation>sie sind keine CT-Bildobjekte</translation>
    </message>
    <message>
        <source>their image type is that of a map, as of a material or of perfusion</source>
        <translation>ihr Image Type ist der einer Karte, etwa eines Materials oder der Perfusion</translation>
    </message>
    <message>
        <source>A picture of that size cannot be written as DICOM.</source>
        <translation>Ein Bild dieser Größe kann nicht als DICOM geschrieben werden.</translation>
    </message>
    <message>
        <source>The pixels do not fit the size of the picture.</source>
        <translation>Die Pixel passen nicht zur Größe des Bildes.</translation>
    </message>
    <message>
        <source>Draw the picture again.</source>
        <translation>Zeichnen Sie das Bild noch einmal.</translation>
    </message>
    <message>
        <source>Take at most {} letters, digits and signs, without a backslash.</source>
        <translation>Nehmen Sie höchstens {} Buchstaben, Ziffern und Zeichen, ohne umgekehrten Schrägstrich.</translation>
    </message>
    <message>
        <source>Write the picture without patient and study, or as PNG.</source>
        <translation>Speichern Sie das Bild ohne Patient und Studie oder als PNG.</translation>
    </message>
    <message>
        <source>Only CT and MR volumes can be written as DICOM.</source>
        <translation>Nur CT- und MR-Volumen können als DICOM geschrieben werden.</translation>
    </message>
    <message>
        <source>The rows and columns of this volume are not perpendicular, which DICOM cannot express.</source>
        <translation>Zeilen und Spalten dieses Volumens stehen nicht senkrecht aufeinander, was DICOM nicht ausdrücken kann.</translation>
    </message>
    <message>
        <source>The file holds {} volumes, one for each point in time.</source>
        <translation>Die Datei enthält {} Volumen, eines je Zeitpunkt.</translation>
    </message>
    <message>
        <source>The file does not say how the image lies in the patient: its axes were taken to lead to the patient&apos;s left, back and head. Left and right may be exchanged.</source>
        <translation>Die Datei sagt nicht, wie das Bild im Patienten liegt: es wurde angenommen, dass seine Achsen nach links, hinten und zum Kopf des Patienten führen. Links und rechts können vertauscht sein.</translation>
    </message>
    <message>
        <source>Known are {}.</source>
        <translation>Bekannt sind {}.</translation>
    </message>
    <message>
        <source>The file does not name the unit of its values: none was assumed. Presets for Hounsfield units do not fit.</source>
        <translation>Die Datei nennt die Einheit ihrer Werte nicht: keine wurde angenommen. Voreinstellungen für Hounsfield-Einheiten passen nicht.</translation>
    </message>
    <message>
        <source>Macula wrote this file, with values in {}; a program that changed them since need not have said so.</source>
        <translation>Macula hat diese Datei geschrieben, mit Werten in {}; ein Programm, das sie seither geändert hat, muss das nicht gesagt haben.</translation>
    </message>
    <message>
        <source>read the header of this volume</source>
        <translation>den Kopf dieses Volumens zu lesen</translation>
    </message>
    <message>
        <source>read this volume</source>
        <translation>dieses Volumen zu lesen</translation>
    </message>
    <message>
        <source>The weights do not fit the pictures.</source>
        <translation>Die Gewichte passen nicht zu den Bildern.</translation>
    </message>
    <message>
        <source>A weight is no number.</source>
        <translation>Ein Gewicht ist keine Zahl.</translation>
    </message>
    <message>
        <source>Values and mask are not of one size.</source>
        <translation>Werte und Maske sind nicht gleich groß.</translation>
    </message>
    <message>
        <source>A value to average is no number.</source>
        <translation>Ein zu mittelnder Wert ist keine Zahl.</translation>
    </message>
    <message>
        <source>This build cannot read {} pictures.</source>
        <translation>Diese Fassung kann keine {}-Bilder lesen.</translation>
    </message>
    <message>
        <source>A picture to compare is empty.</source>
        <translation>Ein zu vergleichendes Bild ist leer.</translation>
    </message>
    <message>
        <source>A picture to compare holds linear light, not display values.</source>
        <translation>Ein zu vergleichendes Bild enthält lineares Licht, keine Anzeigewerte.</translation>
    </message>
    <message>
        <source>A picture to compare has values that are no numbers.</source>
        <translation>Ein zu vergleichendes Bild hat Werte, die keine Zahlen sind.</translation>
    </message>
    <message>
        <source>Preparing the volume</source>
        <translation>Das Volumen wird vorbereitet</translation>
    </message>
    <message>
        <source>Preparing what is shown</source>
        <translation>Das Gezeigte wird vorbereitet</translation>
    </message>
    <message>
        <source>The picture could not be made.</source>
        <translation>Das Bild konnte nicht erstellt werden.</translation>
    </message>
    <message>
        <source>Open the study again, or start the program with another --device.</source>
        <translation>Öffnen Sie die Studie noch einmal, oder starten Sie das Programm mit einem anderen --device.</translation>
    </message>
    <message>
        <source>There is not enough memory to show this study.</source>
        <translation>Es ist nicht genug Speicher da, um diese Studie zu zeigen.</translation>
    </message>
    <message>
        <source>Starting the graphics device</source>
        <translation>Das Grafikgerät wird gestartet</translation>
    </message>
    <message>
        <source>The picture was removed</source>
        <translation>Das Bild wurde entfernt</translation>
    </message>
    <message>
        <source>The device is started again</source>
        <translation>Das Gerät wird wieder gestartet</translation>
    </message>
    <message>
        <source>Stopped while stored sessions were waited for.</source>
        <translation>Angehalten, während auf gespeicherte Sitzungen gewartet wurde.</translation>
    </message>
    <message>
        <source>Looking for a stored model</source>
        <translation>Ein gespeichertes Modell wird gesucht</translation>
    </message>
    <message>
        <source>Saving the model</source>
        <translation>Das Modell wird gespeichert</translation>
    </message>
    <message>
        <source>End it with {}.</source>
        <translation>Lassen Sie ihn auf {} enden.</translation>
    </message>
    <message>
        <source>another study</source>
        <translation>einer anderen Studie</translation>
    </message>
    <message>
        <source>another preset</source>
        <translation>einer anderen Voreinstellung</translation>
    </message>
    <message>
        <source>another clip</source>
        <translation>einem anderen Beschnitt</translation>
    </message>
    <message>
        <source>other lights</source>
        <translation>einer anderen Beleuchtung</translation>
    </message>
    <message>
        <source>another {}</source>
        <translation>einem anderen Wert: {}</translation>
    </message>
    <message>
        <source>another second volume or other colours of segments</source>
        <translation>einem anderen zweiten Volumen oder anderen Farben der Segmente</translation>
    </message>
    <message>
        <source>macula train draws no second volume and no colours of segments: train anew without them.</source>
        <translation>macula train zeichnet kein zweites Volumen und keine Farben der Segmente: trainieren Sie ohne diese neu.</translation>
    </message>
    <message>
        <source>Give the PATH, --series, --preset, --clip, --remove-table and --lights that it was made with, or train anew.</source>
        <translation>Geben Sie PATH, --series, --preset, --clip, --remove-table und --lights so an, wie es erstellt wurde, oder trainieren Sie neu.</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>version 1; newer ones need a newer Macula</source>
        <translation>Version 1; neuere brauchen ein neueres Macula</translation>
    </message>
    <message>
        <source>more pixels than those before</source>
        <translation>mehr Pixel als die davor</translation>
    </message>
    <message>
        <source>a slower point with less error</source>
        <translation>ein langsamerer Punkt mit kleinerem Fehler</translation>
    </message>
    <message>
        <source>Please report this: {}</source>
        <translation>Bitte melden Sie dies: {}</translation>
    </message>
    <message>
        <source>an eye, a target and an upright that make a camera</source>
        <translation>ein Auge, ein Ziel und eine Richtung nach oben, die eine Kamera ergeben</translation>
    </message>
    <message>
        <source>The preset cannot be kept: {}</source>
        <translation>Die Voreinstellung kann nicht behalten werden: {}</translation>
    </message>
    <message>
        <source>What is seen cannot be kept: {}</source>
        <translation>Das Gezeigte kann nicht behalten werden: {}</translation>
    </message>
    <message>
        <source>The clock of this machine shows an earlier time than an opening of a study that is stored, so nothing was deleted for its age.</source>
        <translation>Die Uhr dieses Rechners zeigt eine frühere Zeit, als beim Öffnen einer Studie gespeichert wurde. Deshalb wurde nichts seines Alters wegen gelöscht.</translation>
    </message>
    <message>
        <source>The clock of this machine is so far ahead of the last opening that every stored study would be deleted for its age; those that were not old then were kept.</source>
        <translation>Die Uhr dieses Rechners ist der letzten Öffnung so weit voraus, dass jede gespeicherte Studie ihres Alters wegen gelöscht würde; was damals nicht alt war, wurde behalten.</translation>
    </message>
    <message>
        <source>Set the clock. Where it is right, run `macula sessions purge --unused-days N --trust-clock`.</source>
        <translation>Stellen Sie die Uhr. Wenn sie stimmt, rufen Sie `macula sessions purge --unused-days N --trust-clock` auf.</translation>
    </message>
    <message>
        <source>Where the clock is right there is nothing to do: from tomorrow on it is believed. To delete now, run `macula sessions purge --unused-days N --trust-clock`.</source>
        <translation>Wenn die Uhr stimmt, ist nichts zu tun: ab morgen wird ihr geglaubt. Um jetzt zu löschen, rufen Sie `macula sessions purge --unused-days N --trust-clock` auf.</translation>
    </message>
    <message>
        <source>1 study was</source>
        <translation>1 Studie wurde</translation>
    </message>
    <message>
        <source>{} studies were</source>
        <translation>{} Studien wurden</translation>
    </message>
    <message>
        <source>1 folder</source>
        <translation>1 Ordner</translation>
    </message>
    <message>
        <source>{} folders</source>
        <translation>{} Ordner</translation>
    </message>
    <message>
        <source>1 row</source>
        <translation>1 Zeile</translation>
    </message>
    <message>
        <source>{} rows</source>
        <translation>{} Zeilen</translation>
    </message>
    <message>
        <source>1 model</source>
        <translation>1 Modell</translation>
    </message>
    <message>
        <source>{} models</source>
        <translation>{} Modelle</translation>
    </message>
    <message>
        <source>1 stored state</source>
        <translation>1 gespeicherter Zustand</translation>
    </message>
    <message>
        <source>{} stored states</source>
        <translation>{} gespeicherte Zustände</translation>
    </message>
    <message>
        <source>There is not enough memory to keep this study&apos;s model.</source>
        <translation>Es ist nicht genug Speicher da, um das Modell dieser Studie zu behalten.</translation>
    </message>
    <message>
        <source>Stored sessions could not be opened.</source>
        <translation>Gespeicherte Sitzungen konnten nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>What was not opened for long could not be deleted.</source>
        <translation>Was lange nicht geöffnet wurde, konnte nicht gelöscht werden.</translation>
    </message>
    <message>
        <source>macula sessions list shows those there are.</source>
        <translation>macula sessions list zeigt, welche es gibt.</translation>
    </message>
    <message>
        <source>coloured segments</source>
        <translation>farbige Segmente</translation>
    </message>
    <message>
        <source>Segments have no colours in this look: they have in all but projections.</source>
        <translation>Segmente haben in dieser Darstellung keine Farben: sie haben sie in allen außer Projektionen.</translation>
    </message>
    <message>
        <source>Segments are coloured: in them colours are no values of the preset.</source>
        <translation>Segmente sind gefärbt: in ihnen sind Farben keine Werte der Voreinstellung.</translation>
    </message>
    <message>
        <source>The picture is noisier than its limit of noise.</source>
        <translation>Das Bild rauscht stärker als seine Grenze für Rauschen.</translation>
    </message>
    <message>
        <source>{} samples were not finite and were dropped; please report this.</source>
        <translation>{} Abtastungen waren nicht endlich und wurden weggelassen; bitte melden Sie das.</translation>
    </message>
    <message>
        <source>{} light paths were too long for the device and were dropped.</source>
        <translation>{} Lichtpfade waren zu lang für das Gerät und wurden weggelassen.</translation>
    </message>
    <message>
        <source>Light met matter {} times that was denser than its bound, and passed too easily; please report this.</source>
        <translation>Licht traf {}-mal auf Materie, die dichter war als ihre Schranke, und drang zu leicht hindurch; bitte melden Sie dies.</translation>
    </message>
    <message>
        <source>Pictures left out: there were too many. Lower --pictures or --size.</source>
        <translation>Bilder weggelassen: es waren zu viele. Verringern Sie --pictures oder --size.</translation>
    </message>
    <message>
        <source>all but projections</source>
        <translation>allen außer Projektionen</translation>
    </message>
    <message>
        <source>open the device {}</source>
        <translation>das Gerät {} öffnen</translation>
    </message>
    <message>
        <source>wait for the graphics device</source>
        <translation>auf das Grafikgerät warten</translation>
    </message>
    <message>
        <source>prepare work for the graphics device</source>
        <translation>Arbeit für das Grafikgerät vorbereiten</translation>
    </message>
    <message>
        <source>submit work to the graphics device</source>
        <translation>Arbeit an das Grafikgerät geben</translation>
    </message>
    <message>
        <source>it offers Vulkan {}.{}, and 1.3 is needed</source>
        <translation>es bietet Vulkan {}.{}, und 1.3 wird gebraucht</translation>
    </message>
    <message>
        <source>it lacks {}</source>
        <translation>ihm fehlt {}</translation>
    </message>
    <message>
        <source>it has no queue for compute</source>
        <translation>es hat keine Queue, die rechnen kann</translation>
    </message>
    <message>
        <source>it lacks timeline semaphores</source>
        <translation>ihm fehlen Timeline-Semaphore</translation>
    </message>
    <message>
        <source>it lacks scalar block layout</source>
        <translation>ihm fehlt scalar block layout</translation>
    </message>
    <message>
        <source>it lacks synchronization2</source>
        <translation>ihm fehlt synchronization2</translation>
    </message>
    <message>
        <source>it lacks maintenance4</source>
        <translation>ihm fehlt maintenance4</translation>
    </message>
    <message>
        <source>start Vulkan</source>
        <translation>Vulkan starten</translation>
    </message>
    <message>
        <source>listen to the Vulkan validation layer</source>
        <translation>der Prüfschicht von Vulkan zuhören</translation>
    </message>
    <message>
        <source>prepare the shader {}</source>
        <translation>den Shader {} vorbereiten</translation>
    </message>
    <message>
        <source>record &quot;{}&quot;</source>
        <translation>„{}“ aufzeichnen</translation>
    </message>
    <message>
        <source>read the timings</source>
        <translation>die Zeiten lesen</translation>
    </message>
    <message>
        <source>find memory for the {}</source>
        <translation>Speicher finden für: {}</translation>
    </message>
    <message>
        <source>get {} for the {}</source>
        <translation>{} belegen für: {}</translation>
    </message>
    <message>
        <source>buffer &quot;{}&quot;</source>
        <translation>Puffer „{}“</translation>
    </message>
    <message>
        <source>create the {}</source>
        <translation>anlegen: {}</translation>
    </message>
    <message>
        <source>create the {} of {}</source>
        <translation>anlegen: {} von {}</translation>
    </message>
    <message>
        <source>bind memory to the {}</source>
        <translation>Speicher binden an: {}</translation>
    </message>
    <message>
        <source>map the {}</source>
        <translation>einblenden: {}</translation>
    </message>
    <message>
        <source>texel buffer &quot;{}&quot;</source>
        <translation>Texelpuffer „{}“</translation>
    </message>
    <message>
        <source>{} elements</source>
        <translation>{} Elemente</translation>
    </message>
    <message>
        <source>image &quot;{}&quot;</source>
        <translation>Bild „{}“</translation>
    </message>
    <message>
        <source>{} pixels along one edge</source>
        <translation>{} Pixel entlang einer Kante</translation>
    </message>
    <message>
        <source>create the {} of {} x {} x {}</source>
        <translation>anlegen: {} von {} x {} x {}</translation>
    </message>
    <message>
        <source>create the sampler &quot;{}&quot;</source>
        <translation>den Sampler „{}“ anlegen</translation>
    </message>
    <message>
        <source>open the image that another program shares</source>
        <translation>das Bild öffnen, das ein anderes Programm teilt</translation>
    </message>
    <message>
        <source>Describe the image and its memory exactly as they were made.</source>
        <translation>Beschreiben Sie das Bild und seinen Speicher genau so, wie sie gemacht wurden.</translation>
    </message>
    <message>
        <source>Give none: then the picture is there when the call returns.</source>
        <translation>Geben Sie keines an: dann ist das Bild da, wenn der Aufruf zurückkehrt.</translation>
    </message>
    <message>
        <source>{} Or open it with VK_KHR_external_semaphore_fd, if it offers that.</source>
        <translation>{} Oder öffnen Sie es mit VK_KHR_external_semaphore_fd, wenn es das bietet.</translation>
    </message>
    <message>
        <source>semaphore</source>
        <translation>Semaphor</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>bring data to the graphics device</source>
        <translation>Daten auf das Grafikgerät bringen</translation>
    </message>
    <message>
        <source>ask for the formats of the window</source>
        <translation>nach den Formaten des Fensters fragen</translation>
    </message>
    <message>
        <source>find a format for the window with 8 bits per colour</source>
        <translation>ein Format mit 8 Bit je Farbe für das Fenster finden</translation>
    </message>
    <message>
        <source>ask whether the device can draw in the window</source>
        <translation>fragen, ob das Gerät im Fenster zeichnen kann</translation>
    </message>
    <message>
        <source>create a semaphore</source>
        <translation>ein Semaphor anlegen</translation>
    </message>
    <message>
        <source>resize the window</source>
        <translation>die Größe des Fensters ändern</translation>
    </message>
    <message>
        <source>ask for the size of the window</source>
        <translation>nach der Größe des Fensters fragen</translation>
    </message>
    <message>
        <source>create the images of the window</source>
        <translation>die Bilder des Fensters anlegen</translation>
    </message>
    <message>
        <source>get the images of the window</source>
        <translation>die Bilder des Fensters holen</translation>
    </message>
    <message>
        <source>get an image of the window</source>
        <translation>ein Bild des Fensters holen</translation>
    </message>
    <message>
        <source>show the image in the window</source>
        <translation>das Bild im Fenster zeigen</translation>
    </message>
    <message>
        <source>The views cannot be chosen this way.</source>
        <translation>Die Ansichten können so nicht gewählt werden.</translation>
    </message>
    <message>
        <source>Give a start distance above 0, an increment and a variability of 0 or above, and a field of view of 0.1 to 170 degrees.</source>
        <translation>Geben Sie einen Anfangsabstand über 0, einen Schritt und eine Streuung von 0 oder mehr und ein Blickfeld von 0.1 bis 170 Grad an.</translation>
    </message>
    <message>
        <source>Use a newer Macula, or export the model as PLY there.</source>
        <translation>Verwenden Sie ein neueres Macula, oder exportieren Sie das Modell dort als PLY.</translation>
    </message>
    <message>
        <source>Export it as PLY with the Macula that made it.</source>
        <translation>Exportieren Sie es als PLY mit dem Macula, das es erstellt hat.</translation>
    </message>
    <message>
        <source>{} or {}</source>
        <translation>{} oder {}</translation>
    </message>
    <message>
        <source>Choose a {} file.</source>
        <translation>Wählen Sie eine {}-Datei.</translation>
    </message>
    <message>
        <source>The file is no {} model.</source>
        <translation>Die Datei ist kein {}-Modell.</translation>
    </message>
    <message>
        <source>Models are written as {}.</source>
        <translation>Modelle werden als {} gespeichert.</translation>
    </message>
    <message>
        <source>None of the model&apos;s splats can be used.</source>
        <translation>Keines der Splats des Modells kann verwendet werden.</translation>
    </message>
    <message>
        <source>splats</source>
        <translation>Splats</translation>
    </message>
    <message>
        <source>elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>Of the second volume: {}</source>
        <translation>Zum zweiten Volumen: {}</translation>
    </message>
    <message>
        <source>The environment picture is empty.</source>
        <translation>Das Umgebungsbild ist leer.</translation>
    </message>
    <message>
        <source>The environment picture has values that are negative or not finite.</source>
        <translation>Das Umgebungsbild hat Werte, die negativ oder nicht endlich sind.</translation>
    </message>
    <message>
        <source>&quot;patient&quot; or &quot;camera&quot;</source>
        <translation>„patient“ oder „camera“</translation>
    </message>
    <message>
        <source>a light or an ambient sky that is not black</source>
        <translation>ein Licht oder ein Himmel, der nicht schwarz ist</translation>
    </message>
    <message>
        <source>&quot;trilinear&quot;, &quot;stochastic&quot;, &quot;smooth&quot; or &quot;sharp&quot;</source>
        <translation>„trilinear“, „stochastic“, „smooth“ oder „sharp“</translation>
    </message>
    <message>
        <source>Choose a smaller picture, or another device.</source>
        <translation>Wählen Sie ein kleineres Bild oder ein anderes Gerät.</translation>
    </message>
    <message>
        <source>{} bounces cannot be traced.</source>
        <translation>{} Streuungen können nicht verfolgt werden.</translation>
    </message>
    <message>
        <source>Choose 1 to {}.</source>
        <translation>Wählen Sie 1 bis {}.</translation>
    </message>
    <message>
        <source>The exposure is not usable.</source>
        <translation>Die Belichtung ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose a number above 0, up to {}.</source>
        <translation>Wählen Sie eine Zahl über 0, bis {}.</translation>
    </message>
    <message>
        <source>The strength of the lights is not usable.</source>
        <translation>Die Stärke der Beleuchtung ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose a number from 0 to {}.</source>
        <translation>Wählen Sie eine Zahl von 0 bis {}.</translation>
    </message>
    <message>
        <source>The rotation of the lights is not usable.</source>
        <translation>Die Drehung der Beleuchtung ist nicht brauchbar.</translation>
    </message>
    <message>
        <source>Choose an angle in degrees.</source>
        <translation>Wählen Sie einen Winkel in Grad.</translation>
    </message>
    <message>
        <source>Give a centre, and a width above 0.</source>
        <translation>Geben Sie eine Mitte und eine Breite über 0 an.</translation>
    </message>
    <message>
        <source>Ask for 1 to {} points, with 1 path or more.</source>
        <translation>Verlangen Sie 1 bis {} Punkte, mit 1 Pfad oder mehr.</translation>
    </message>
    <message>
        <source>Show less of the volume by another preset or a clip, or allow more memory for voxels.</source>
        <translation>Zeigen Sie mit einer anderen Voreinstellung oder einem Beschnitt weniger vom Volumen, oder erlauben Sie mehr Speicher für Voxel.</translation>
    </message>
    <message>
        <source>Show less of the volume by another preset or a clip: this device&apos;s buffers hold no more.</source>
        <translation>Zeigen Sie mit einer anderen Voreinstellung oder einem Beschnitt weniger vom Volumen: Die Puffer dieses Geräts fassen nicht mehr.</translation>
    </message>
    <message>
        <source>Show less of the volume by another preset or a clip, or use a device with more memory.</source>
        <translation>Zeigen Sie mit einer anderen Voreinstellung oder einem Beschnitt weniger vom Volumen, oder verwenden Sie ein Gerät mit mehr Speicher.</translation>
    </message>
    <message>
        <source>What is visible takes {:.1f} MiB and only {:.1f} MiB can be had: {} of {} visible blocks ({:.0f} %) are shown {}.</source>
        <translation>Das Sichtbare braucht {:.1f} MiB, und nur {:.1f} MiB sind zu haben: {} von {} sichtbaren Blöcken ({:.0f} %) werden mit {} gezeigt.</translation>
    </message>
    <message>
        <source>{} voxels as one along each edge or less</source>
        <translation>je {} Voxeln als einem entlang jeder Kante oder weniger</translation>
    </message>
    <message>
        <source>{} voxels as one along each edge</source>
        <translation>je {} Voxeln als einem entlang jeder Kante</translation>
    </message>
    <message>
        <source>there are more than six planes</source>
        <translation>es sind mehr als sechs Ebenen</translation>
    </message>
    <message>
        <source>Give six planes at most.</source>
        <translation>Geben Sie höchstens sechs Ebenen an.</translation>
    </message>
    <message>
        <source>the box has no size</source>
        <translation>der Quader hat keine Größe</translation>
    </message>
    <message>
        <source>Give a centre and positive half sizes in mm.</source>
        <translation>Geben Sie eine Mitte und positive halbe Größen in mm an.</translation>
    </message>
    <message>
        <source>the axes of the box are not at right angles</source>
        <translation>die Achsen des Quaders stehen nicht senkrecht</translation>
    </message>
    <message>
        <source>Give three unit vectors.</source>
        <translation>Geben Sie drei Einheitsvektoren an.</translation>
    </message>
    <message>
        <source>a plane has no direction</source>
        <translation>eine Ebene hat keine Richtung</translation>
    </message>
    <message>
        <source>Give its normal as a unit vector, and its distance in mm.</source>
        <translation>Geben Sie ihre Normale als Einheitsvektor an und ihren Abstand in mm.</translation>
    </message>
    <message>
        <source>the corner has no direction</source>
        <translation>die Ecke hat keine Richtung</translation>
    </message>
    <message>
        <source>Give three signs, such as L, A, S.</source>
        <translation>Geben Sie drei Seiten an, zum Beispiel L, A, S.</translation>
    </message>
    <message>
        <source>the ball has no size</source>
        <translation>die Kugel hat keine Größe</translation>
    </message>
    <message>
        <source>Give a centre and a positive radius in mm.</source>
        <translation>Geben Sie eine Mitte und einen positiven Radius in mm an.</translation>
    </message>
    <message>
        <source>there is no segmentation to mask with</source>
        <translation>es gibt keine Segmentierung zum Ausblenden</translation>
    </message>
    <message>
        <source>Give one.</source>
        <translation>Geben Sie eine an.</translation>
    </message>
    <message>
        <source>the window of its faces has no width</source>
        <translation>die Fensterung seiner Flächen hat keine Breite</translation>
    </message>
    <message>
        <source>Give a centre and a positive width.</source>
        <translation>Geben Sie eine Mitte und eine positive Breite an.</translation>
    </message>
    <message>
        <source>&quot;inside&quot; or &quot;outside&quot;</source>
        <translation>„inside“ oder „outside“</translation>
    </message>
    <message>
        <source>&quot;low&quot; below &quot;high&quot; on each axis</source>
        <translation>„low“ unter „high“ auf jeder Achse</translation>
    </message>
    <message>
        <source>L or R, then A or P, then S or I, such as &quot;LAS&quot;</source>
        <translation>L oder R, dann A oder P, dann S oder I, etwa „LAS“</translation>
    </message>
    <message>
        <source>three letters, such as &quot;LAS&quot;</source>
        <translation>drei Buchstaben, etwa „LAS“</translation>
    </message>
    <message>
        <source>a direction, not all zeros</source>
        <translation>eine Richtung, nicht nur Nullen</translation>
    </message>
    <message>
        <source>&quot;series&quot;, or center and width</source>
        <translation>„series“, oder center und width</translation>
    </message>
    <message>
        <source>greyFaces beside it</source>
        <translation>greyFaces daneben</translation>
    </message>
    <message>
        <source>&quot;clear&quot; or &quot;black&quot;</source>
        <translation>„clear“ oder „black“</translation>
    </message>
    <message>
        <source>a number from {} to {}</source>
        <translation>eine Zahl von {} bis {}</translation>
    </message>
    <message>
        <source>a number not below {}</source>
        <translation>eine Zahl nicht unter {}</translation>
    </message>
    <message>
        <source>a number not above {}</source>
        <translation>eine Zahl nicht über {}</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>line {}, column {}</source>
        <translation>Zeile {}, Spalte {}</translation>
    </message>
    <message>
        <source>The key {} is missing.</source>
        <translation>Der Schlüssel {} fehlt.</translation>
    </message>
    <message>
        <source>Add it.</source>
        <translation>Fügen Sie ihn hinzu.</translation>
    </message>
    <message>
        <source>an object, { … }</source>
        <translation>ein Objekt, { … }</translation>
    </message>
    <message>
        <source>The key {} is unknown.</source>
        <translation>Der Schlüssel {} ist unbekannt.</translation>
    </message>
    <message>
        <source>Known here: {}.</source>
        <translation>Hier bekannt: {}.</translation>
    </message>
    <message>
        <source>a list of {} entries</source>
        <translation>eine Liste mit {} Einträgen</translation>
    </message>
    <message>
        <source>a list of {} to {} entries</source>
        <translation>eine Liste mit {} bis {} Einträgen</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>ein Text in Anführungszeichen</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>{} is not as expected.</source>
        <translation>{} ist nicht wie erwartet.</translation>
    </message>
    <message>
        <source>The file</source>
        <translation>Die Datei</translation>
    </message>
    <message>
        <source>The file is nested too deeply at {}.</source>
        <translation>Die Datei ist bei {} zu tief geschachtelt.</translation>
    </message>
    <message>
        <source>Give a file that is nested at most {} deep.</source>
        <translation>Wählen Sie eine Datei, die höchstens {} tief geschachtelt ist.</translation>
    </message>
    <message>
        <source>An object of the file has too many keys, at {}.</source>
        <translation>Ein Objekt der Datei hat zu viele Schlüssel, bei {}.</translation>
    </message>
    <message>
        <source>Give a file whose objects have at most {} keys.</source>
        <translation>Wählen Sie eine Datei, deren Objekte höchstens {} Schlüssel haben.</translation>
    </message>
    <message>
        <source>The file is no valid JSON from {} on.</source>
        <translation>Die Datei ist ab {} kein gültiges JSON.</translation>
    </message>
    <message>
        <source>Look for a missing comma, quote or bracket there or just before.</source>
        <translation>Suchen Sie dort oder kurz davor nach einem fehlenden Komma, Anführungszeichen oder einer Klammer.</translation>
    </message>
    <message>
        <source>The file is no valid JSON.</source>
        <translation>Die Datei ist kein gültiges JSON.</translation>
    </message>
    <message>
        <source>Look for numbers that are too large.</source>
        <translation>Suchen Sie nach Zahlen, die zu groß sind.</translation>
    </message>
    <message>
        <source>The preset&apos;s gradient of steep matter must be above 0.</source>
        <translation>Der Gradient steiler Materie muss in der Voreinstellung über 0 liegen.</translation>
    </message>
    <message>
        <source>The preset&apos;s curves of steep matter need points of opacity and of colour, finite and sorted by value.</source>
        <translation>Die Kurven steiler Materie brauchen in der Voreinstellung Punkte der Deckkraft und der Farbe, endlich und nach Wert sortiert.</translation>
    </message>
    <message>
        <source>An opacity of the preset&apos;s steep matter, a colour, a midpoint or a sharpness lies outside 0 to 1.</source>
        <translation>Eine Deckkraft der steilen Materie der Voreinstellung, eine Farbe, ein Mittelpunkt oder eine Schärfe liegt nicht in 0 bis 1.</translation>
    </message>
    <message>
        <source>The preset&apos;s opacity points are missing, not finite, or not sorted by value.</source>
        <translation>Die Deckkraftpunkte der Voreinstellung fehlen, sind nicht endlich oder nicht nach Wert sortiert.</translation>
    </message>
    <message>
        <source>The preset&apos;s colour points are missing, not finite, or not sorted by value.</source>
        <translation>Die Farbpunkte der Voreinstellung fehlen, sind nicht endlich oder nicht nach Wert sortiert.</translation>
    </message>
    <message>
        <source>The preset&apos;s gradient opacity points are not finite or not sorted by value.</source>
        <translation>Die Punkte der Gradienten-Deckkraft der Voreinstellung sind nicht endlich oder nicht nach Wert sortiert.</translation>
    </message>
    <message>
        <source>An opacity of the preset, a midpoint or a sharpness lies outside 0 to 1.</source>
        <translation>Eine Deckkraft der Voreinstellung, ein Mittelpunkt oder eine Schärfe liegt außerhalb von 0 bis 1.</translation>
    </message>
    <message>
        <source>A colour of the preset, a midpoint or a sharpness lies outside 0 to 1.</source>
        <translation>Eine Farbe der Voreinstellung, ein Mittelpunkt oder eine Schärfe liegt außerhalb von 0 bis 1.</translation>
    </message>
    <message>
        <source>The preset&apos;s unit distance must be above 0 mm.</source>
        <translation>Die Bezugsdicke der Voreinstellung muss über 0 mm liegen.</translation>
    </message>
    <message>
        <source>The preset&apos;s density must be 0 or above.</source>
        <translation>Die Dichte der Voreinstellung muss 0 oder mehr sein.</translation>
    </message>
    <message>
        <source>The preset&apos;s albedo must lie in 0 to 1.</source>
        <translation>Die Albedo der Voreinstellung muss in 0 bis 1 liegen.</translation>
    </message>
    <message>
        <source>The preset&apos;s scattering anisotropy must lie between -0.99 and 0.99.</source>
        <translation>Die Streuanisotropie der Voreinstellung muss zwischen -0,99 und 0,99 liegen.</translation>
    </message>
    <message>
        <source>The preset&apos;s surface weight or reflectance lies outside 0 to 1, or its roughness outside 0.1 to 1.</source>
        <translation>Gewicht oder Reflexionsgrad der Oberfläche liegen in der Voreinstellung nicht in 0 bis 1, oder ihre Rauheit nicht in 0,1 bis 1.</translation>
    </message>
    <message>
        <source>The preset&apos;s surface gradient must be above 0.</source>
        <translation>Der Gradient der Oberfläche muss in der Voreinstellung über 0 liegen.</translation>
    </message>
    <message>
        <source>The preset&apos;s range to fit to the volume is empty.</source>
        <translation>Der Bereich der Voreinstellung, der an das Volumen angepasst wird, ist leer.</translation>
    </message>
    <message>
        <source>points sorted by x: not below {}</source>
        <translation>nach x sortierte Punkte: nicht unter {}</translation>
    </message>
    <message>
        <source>&quot;HU&quot; or &quot;raw&quot;</source>
        <translation>„HU“ oder „raw“</translation>
    </message>
    <message>
        <source>lower-case letters, digits and hyphens</source>
        <translation>Kleinbuchstaben, Ziffern und Bindestriche</translation>
    </message>
    <message>
        <source>true, false, &quot;foreground&quot; or &quot;valueRange&quot;</source>
        <translation>true, false, „foreground“ oder „valueRange“</translation>
    </message>
    <message>
        <source>&quot;rgb&quot;, &quot;hsv&quot;, &quot;hsvWrap&quot;, &quot;lab&quot;, &quot;diverging&quot; or &quot;step&quot;</source>
        <translation>„rgb“, „hsv“, „hsvWrap“, „lab“, „diverging“ oder „step“</translation>
    </message>
    <message>
        <source>two ascending numbers</source>
        <translation>zwei aufsteigende Zahlen</translation>
    </message>
    <message>
        <source>&quot;nearest&quot;, &quot;linear&quot; or &quot;cubic&quot;</source>
        <translation>„nearest“, „linear“ oder „cubic“</translation>
    </message>
    <message>
        <source>The preset was stretched to this volume: its {:g} to {:g} are drawn at {:g} to {:g}, {}.</source>
        <translation>Die Voreinstellung wurde auf dieses Volumen gestreckt: ihre {:g} bis {:g} liegen bei {:g} bis {:g}, {}.</translation>
    </message>
    <message>
        <source>the background and the 98th percentile of the foreground</source>
        <translation>dem Hintergrund und dem 98. Perzentil des Vordergrunds</translation>
    </message>
    <message>
        <source>the 2nd and 98th percentile of the foreground</source>
        <translation>dem 2. und 98. Perzentil des Vordergrunds</translation>
    </message>
    <message>
        <source>the smallest and largest value</source>
        <translation>dem kleinsten und größten Wert</translation>
    </message>
    <message>
        <source>Compare brightness and colours only within this volume.</source>
        <translation>Vergleichen Sie Helligkeit und Farben nur innerhalb dieses Volumens.</translation>
    </message>
    <message>
        <source>The preset names the opacity table &apos;{}&apos;, which is not in the file.</source>
        <translation>Die Voreinstellung nennt die Deckkrafttabelle „{}“, die nicht in der Datei ist.</translation>
    </message>
    <message>
        <source>The shading &apos;{}&apos; is not known; the default shading was taken.</source>
        <translation>Die Schattierung „{}“ ist nicht bekannt; die übliche wurde genommen.</translation>
    </message>
    <message>
        <source>a window within -1e9 to 1e9</source>
        <translation>eine Fensterung von -1e9 bis 1e9</translation>
    </message>
    <message>
        <source>groups of {} numbers</source>
        <translation>Gruppen von {} Zahlen</translation>
    </message>
    <message>
        <source>RGB, HSV, Lab, CIELAB, Diverging or Step</source>
        <translation>RGB, HSV, Lab, CIELAB, Diverging oder Step</translation>
    </message>
    <message>
        <source>a continuous colour map: categories cannot be drawn as one</source>
        <translation>eine stetige Farbtabelle: Kategorien können nicht so gezeichnet werden</translation>
    </message>
    <message>
        <source>a linear scale</source>
        <translation>eine lineare Skala</translation>
    </message>
    <message>
        <source>colours at two values or more</source>
        <translation>Farben bei zwei oder mehr Werten</translation>
    </message>
    <message>
        <source>The preset names the colour table &apos;{}&apos;, which is not there.</source>
        <translation>Die Voreinstellung nennt die Farbtabelle „{}“, die fehlt.</translation>
    </message>
    <message>
        <source>The preset file is empty.</source>
        <translation>Die Datei der Voreinstellung ist leer.</translation>
    </message>
    <message>
        <source>The file is no preset of a known format.</source>
        <translation>Die Datei ist keine Voreinstellung in einem bekannten Format.</translation>
    </message>
    <message>
        <source>Add # and a name or its place, as in FILE#{}. There are: {}.</source>
        <translation>Hängen Sie # und einen Namen oder die Stelle an, wie in DATEI#{}. Es gibt: {}.</translation>
    </message>
    <message>
        <source>The file holds no preset &apos;{}&apos;.</source>
        <translation>Die Datei enthält keine Voreinstellung „{}“.</translation>
    </message>
    <message>
        <source>There are: {}.</source>
        <translation>Es gibt: {}.</translation>
    </message>
    <message>
        <source>The file does not say what its values are; Hounsfield units of CT were assumed.</source>
        <translation>Die Datei sagt nicht, was ihre Werte sind; Hounsfield-Einheiten eines CT wurden angenommen.</translation>
    </message>
    <message>
        <source>holds &lt;{}&gt;, which no property list does</source>
        <translation>enthält &lt;{}&gt;, was keine Property List tut</translation>
    </message>
    <message>
        <source>The property list {}.</source>
        <translation>Die Property List {}.</translation>
    </message>
    <message>
        <source>the interpolation, 0 for nearest or 1 for linear</source>
        <translation>die Interpolation, 0 für nächste oder 1 für linear</translation>
    </message>
    <message>
        <source>whether it is shaded, 0 or 1</source>
        <translation>ob schattiert wird, 0 oder 1</translation>
    </message>
    <message>
        <source>the diffuse coefficient, 0 or above</source>
        <translation>der diffuse Koeffizient, 0 oder mehr</translation>
    </message>
    <message>
        <source>the ambient coefficient, 0 or above</source>
        <translation>der ambiente Koeffizient, 0 oder mehr</translation>
    </message>
    <message>
        <source>the specular coefficient, 0 or above</source>
        <translation>der spiegelnde Koeffizient, 0 oder mehr</translation>
    </message>
    <message>
        <source>the specular power, 0 or above</source>
        <translation>der spiegelnde Exponent, 0 oder mehr</translation>
    </message>
    <message>
        <source>scalar opacity (line 7)</source>
        <translation>Die Deckkraft (Zeile 7)</translation>
    </message>
    <message>
        <source>gradient opacity (line 8)</source>
        <translation>Die Gradienten-Deckkraft (Zeile 8)</translation>
    </message>
    <message>
        <source>colour (line 9)</source>
        <translation>Die Farbe (Zeile 9)</translation>
    </message>
    <message>
        <source>The effective range cannot be read and was left out: &quot;{}&quot;.</source>
        <translation>Der wirksame Bereich kann nicht gelesen werden und wurde weggelassen: „{}“.</translation>
    </message>
    <message>
        <source>The interpolation of the preset {} is unknown.</source>
        <translation>Die Interpolation der Voreinstellung {} ist unbekannt.</translation>
    </message>
    <message>
        <source>scalarOpacity of {}</source>
        <translation>scalarOpacity von {}</translation>
    </message>
    <message>
        <source>colorTransfer of {}</source>
        <translation>colorTransfer von {}</translation>
    </message>
    <message>
        <source>gradientOpacity of {}</source>
        <translation>gradientOpacity von {}</translation>
    </message>
    <message>
        <source>has something in it that is no usable number, or too many of them</source>
        <translation>enthält etwas, das keine brauchbare Zahl ist, oder zu viele davon</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>should have {:g} numbers and has {:g}</source>
        <translation>sollte {:g} Zahlen haben und hat {:g}</translation>
    </message>
    <message>
        <source>has no points</source>
        <translation>hat keine Punkte</translation>
    </message>
    <message>
        <source>is not made of groups of {}</source>
        <translation>besteht nicht aus Gruppen von {}</translation>
    </message>
    <message>
        <source>has a value that is too large</source>
        <translation>hat einen zu großen Wert</translation>
    </message>
    <message>
        <source>is not sorted: {:g} comes after {:g}</source>
        <translation>ist nicht sortiert: {:g} kommt nach {:g}</translation>
    </message>
    <message>
        <source>The XML file declares entities, which no preset needs.</source>
        <translation>Die XML-Datei deklariert Entities, die keine Voreinstellung braucht.</translation>
    </message>
    <message>
        <source>Remove the DOCTYPE from the file, or take another one.</source>
        <translation>Entfernen Sie den DOCTYPE aus der Datei, oder nehmen Sie eine andere.</translation>
    </message>
    <message>
        <source>The file holds no XML element.</source>
        <translation>Die Datei enthält kein XML-Element.</translation>
    </message>
    <message>
        <source>The file is no valid XML around line {}.</source>
        <translation>Die Datei ist um Zeile {} kein gültiges XML.</translation>
    </message>
    <message>
        <source>Check that it is complete, and look for a missing bracket or quote there.</source>
        <translation>Prüfen Sie, ob sie vollständig ist, und suchen Sie dort nach einer fehlenden Klammer oder einem Anführungszeichen.</translation>
    </message>
    <message>
        <source>The XML file is nested too deeply.</source>
        <translation>Die XML-Datei ist zu tief geschachtelt.</translation>
    </message>
    <message>
        <source>One of the volumes has too few voxels to be registered.</source>
        <translation>Eines der Volumen hat zu wenige Voxel für eine Registrierung.</translation>
    </message>
    <message>
        <source>The volumes do not show enough of the same part of the body to be registered.</source>
        <translation>Die Volumen zeigen für eine Registrierung zu wenig vom selben Teil des Körpers.</translation>
    </message>
    <message>
        <source>A volume of fewer than three slices, rows or columns cannot be registered.</source>
        <translation>Ein Volumen mit weniger als drei Schichten, Zeilen oder Spalten kann nicht registriert werden.</translation>
    </message>
    <message>
        <source>One of the volumes has no values: there is nothing to register by.</source>
        <translation>Eines der Volumen hat keine Werte: es gibt nichts, wonach registriert werden kann.</translation>
    </message>
    <message>
        <source>One of the volumes has the same value everywhere: there is nothing to register by.</source>
        <translation>Eines der Volumen hat überall denselben Wert: es gibt nichts, wonach registriert werden kann.</translation>
    </message>
    <message>
        <source>0 for the first camera</source>
        <translation>0 für die erste Kamera</translation>
    </message>
    <message>
        <source>a later time than that of the camera before</source>
        <translation>eine spätere Zeit als die der Kamera davor</translation>
    </message>
    <message>
        <source>Camera [{}]: {}</source>
        <translation>Kamera [{}]: {}</translation>
    </message>
    <message>
        <source>The head is seen from the front and above, as the images say that it is one.</source>
        <translation>Der Kopf wird von vorn und oben gesehen, da die Bilder sagen, dass es einer ist.</translation>
    </message>
    <message>
        <source>It is seen from the front and above, as a head is: what was scanned is as large as one.</source>
        <translation>Gesehen wird von vorn und oben, wie ein Kopf: das Aufgenommene ist so groß wie einer.</translation>
    </message>
    <message>
        <source>The scan is seen obliquely from above: it is less than half as high as it is wide.</source>
        <translation>Die Aufnahme wird schräg von oben gesehen: sie ist weniger als halb so hoch wie breit.</translation>
    </message>
    <message>
        <source>The patient is seen from the front, slightly turned.</source>
        <translation>Der Patient wird von vorn gesehen, leicht gedreht.</translation>
    </message>
    <message>
        <source>Or give the path of a JSON file.</source>
        <translation>Oder geben Sie den Pfad einer JSON-Datei an.</translation>
    </message>
    <message>
        <source>There is no such clip.</source>
        <translation>Diesen Beschnitt gibt es nicht.</translation>
    </message>
    <message>
        <source>Or give the path of a JSON, HDR or EXR file.</source>
        <translation>Oder geben Sie den Pfad einer JSON-, HDR- oder EXR-Datei an.</translation>
    </message>
    <message>
        <source>Did you mean {}?</source>
        <translation>Meinten Sie {}?</translation>
    </message>
    <message>
        <source>Or give a number from macula presets, or the path of a preset file.</source>
        <translation>Oder geben Sie eine Nummer aus macula presets oder den Pfad einer Voreinstellungsdatei an.</translation>
    </message>
    <message>
        <source>There is no such quality.</source>
        <translation>Diese Qualität gibt es nicht.</translation>
    </message>
    <message>
        <source>The preset is made for other units than those of the series.</source>
        <translation>Die Voreinstellung ist für andere Einheiten gemacht als die der Serie.</translation>
    </message>
    <message>
        <source>Presets for it: {}.</source>
        <translation>Voreinstellungen dafür: {}.</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>superior</translation>
    </message>
    <message>
        <source>The outline has fewer than three points.</source>
        <translation>Der Umriss hat weniger als drei Punkte.</translation>
    </message>
    <message>
        <source>The outline has too many points.</source>
        <translation>Der Umriss hat zu viele Punkte.</translation>
    </message>
    <message>
        <source>A point of the outline is no number.</source>
        <translation>Ein Punkt des Umrisses ist keine Zahl.</translation>
    </message>
    <message>
        <source>The outline encloses nothing.</source>
        <translation>Der Umriss umschließt nichts.</translation>
    </message>
    <message>
        <source>cut with scissors</source>
        <translation>mit der Schere geschnitten</translation>
    </message>
    <message>
        <source>masked</source>
        <translation>maskiert</translation>
    </message>
    <message>
        <source>Nothing is visible in the picture. The series has values from {:g} to {:g}{}.</source>
        <translation>Im Bild ist nichts zu sehen. Die Serie hat Werte von {:g} bis {:g}{}.</translation>
    </message>
    <message>
        <source>Nothing is visible: every voxel of the series is padding.</source>
        <translation>Nichts ist zu sehen: jedes Voxel der Serie ist Füllwert.</translation>
    </message>
    <message>
        <source>No built-in preset would show any of them.</source>
        <translation>Keine eingebaute Voreinstellung würde etwas davon zeigen.</translation>
    </message>
    <message>
        <source>Presets that show some of them: {}.</source>
        <translation>Voreinstellungen, die etwas davon zeigen: {}.</translation>
    </message>
    <message>
        <source>Check the camera and the clip too.</source>
        <translation>Prüfen Sie auch Kamera und Beschnitt.</translation>
    </message>
    <message>
        <source>It is seen through the window {}: choose another one.</source>
        <translation>Es wird durch die Fensterung {} gesehen: wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>table left out</source>
        <translation>Tisch weggelassen</translation>
    </message>
    <message>
        <source>A table was not looked for: {}</source>
        <translation>Ein Tisch wurde nicht gesucht: {}</translation>
    </message>
    <message>
        <source>The clip of the presentation state leaves nothing of this series.</source>
        <translation>Der Beschnitt des Presentation State lässt von dieser Serie nichts übrig.</translation>
    </message>
    <message>
        <source>The clip of the presentation state is of more planes than six.</source>
        <translation>Der Beschnitt des Presentation State hat mehr als sechs Ebenen.</translation>
    </message>
    <message>
        <source>The window is a curve; others get a straight one.</source>
        <translation>Die Fensterung ist eine Kurve; andere Programme erhalten eine gerade.</translation>
    </message>
    <message>
        <source>Others cannot show an average, and show the preset instead.</source>
        <translation>Andere Programme können keinen Mittelwert zeigen und zeigen stattdessen die Voreinstellung.</translation>
    </message>
    <message>
        <source>Opacities that depend on edges (gradients) are for Macula alone.</source>
        <translation>Deckkräfte, die von Kanten (Gradienten) abhängen, gelten nur für Macula.</translation>
    </message>
    <message>
        <source>Others know no steep matter: they show what is halfway between flat and steep.</source>
        <translation>Andere Programme kennen keine steile Materie: sie zeigen, was in der Mitte zwischen flacher und steiler liegt.</translation>
    </message>
    <message>
        <source>Others have no path tracing: of the lights they get the strongest, and how bright the rest is.</source>
        <translation>Andere Programme haben keine Pfadverfolgung: von der Beleuchtung erhalten sie das stärkste Licht und wie hell der Rest ist.</translation>
    </message>
    <message>
        <source>Others show the table, which is left out here.</source>
        <translation>Andere Programme zeigen den Tisch, der hier weggelassen ist.</translation>
    </message>
    <message>
        <source>Others show segments that are hidden here.</source>
        <translation>Andere Programme zeigen Segmente, die hier ausgeblendet sind.</translation>
    </message>
    <message>
        <source>Others show no colours of segments.</source>
        <translation>Andere zeigen keine Farben von Segmenten.</translation>
    </message>
    <message>
        <source>Others show the study without the second volume.</source>
        <translation>Andere zeigen die Studie ohne das zweite Volumen.</translation>
    </message>
    <message>
        <source>Others show what is cut off with scissors here.</source>
        <translation>Andere Programme zeigen, was hier mit der Schere abgeschnitten ist.</translation>
    </message>
    <message>
        <source>Others show boxes, corners and balls that are cut out here.</source>
        <translation>Andere Programme zeigen Quader, Ecken und Kugeln, die hier herausgeschnitten sind.</translation>
    </message>
    <message>
        <source>Grey faces and shadows of what is cut off are for Macula alone.</source>
        <translation>Graue Flächen und Schatten des Abgeschnittenen gelten nur für Macula.</translation>
    </message>
    <message>
        <source>Without patient and study, the second volume and segmentations are not found again.</source>
        <translation>Ohne Patient und Studie werden das zweite Volumen und Segmentierungen nicht wiedergefunden.</translation>
    </message>
    <message>
        <source>The view is too large to be kept as a whole: Macula too shows only what others show.</source>
        <translation>Die Ansicht ist zu groß, um ganz bewahrt zu werden: auch Macula zeigt nur, was andere zeigen.</translation>
    </message>
    <message>
        <source>It is of some of the images alone; the others are shown in the same way.</source>
        <translation>Er gilt nur für einen Teil der Bilder; die anderen werden ebenso gezeigt.</translation>
    </message>
    <message>
        <source>It has no window for its first image here.</source>
        <translation>Er hat hier kein Fenster für sein erstes Bild.</translation>
    </message>
    <message>
        <source>Its window is a table of values (VOI LUT), which is not shown.</source>
        <translation>Sein Fenster ist eine Tabelle von Werten (VOI LUT), die nicht gezeigt wird.</translation>
    </message>
    <message>
        <source>Its window is of other values than those of the volume, and is not shown.</source>
        <translation>Sein Fenster ist von anderen Werten als denen des Volumens und wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>It has several windows; that of its first image is shown.</source>
        <translation>Er hat mehrere Fenster; das seines ersten Bildes wird gezeigt.</translation>
    </message>
    <message>
        <source>Where its images lie is not known: the slices stay where they are.</source>
        <translation>Wo seine Bilder liegen, ist nicht bekannt: die Schichten bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>It turns or mirrors its images, which slices here never do: its part of the image is not shown.</source>
        <translation>Er dreht oder spiegelt seine Bilder, was Schichten hier nie tun: sein Bildausschnitt wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>It asks for the true size on the screen, which is not shown: slices fit their pane.</source>
        <translation>Er verlangt die wahre Größe auf dem Bildschirm, die nicht gezeigt wird: Schichten füllen ihr Feld.</translation>
    </message>
    <message>
        <source>It asks for a fixed magnification, which is not shown: slices fit their pane.</source>
        <translation>Er verlangt eine feste Vergrößerung, die nicht gezeigt wird: Schichten füllen ihr Feld.</translation>
    </message>
    <message>
        <source>Its part of the image lies beside the volume, and is not shown.</source>
        <translation>Sein Bildausschnitt liegt neben dem Volumen und wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>The colours of this projection are shown as greys.</source>
        <translation>Die Farben dieser Projektion werden als Graustufen gezeigt.</translation>
    </message>
    <message>
        <source>The presentation state does not say of which thickness its opacities are; 1 mm is taken.</source>
        <translation>Der Presentation State sagt nicht, für welche Dicke seine Deckkräfte gelten; 1 mm wird angenommen.</translation>
    </message>
    <message>
        <source>Highlights are not drawn.</source>
        <translation>Glanzlichter werden nicht gezeichnet.</translation>
    </message>
    <message>
        <source>Surfaces are shaded from both sides.</source>
        <translation>Flächen werden von beiden Seiten schattiert.</translation>
    </message>
    <message>
        <source>Light comes from the viewer, and not from where the presentation state has it.</source>
        <translation>Das Licht kommt vom Betrachter und nicht von dort, wo der Presentation State es hat.</translation>
    </message>
    <message>
        <source>The picture is larger than that of the presentation state, whose middle is not where it looks at.</source>
        <translation>Das Bild ist größer als das des Presentation State, dessen Mitte nicht sein Blickpunkt ist.</translation>
    </message>
    <message>
        <source>with {}</source>
        <translation>mit {}</translation>
    </message>
    <message>
        <source>with a second volume</source>
        <translation>mit einem zweiten Volumen</translation>
    </message>
    <message>
        <source>registration doubtful</source>
        <translation>Registrierung zweifelhaft</translation>
    </message>
    <message>
        <source>of ANOTHER PATIENT</source>
        <translation>von einem ANDEREN PATIENTEN</translation>
    </message>
    <message>
        <source>perhaps of another patient</source>
        <translation>vielleicht von einem anderen Patienten</translation>
    </message>
    <message>
        <source>Second volume: {}</source>
        <translation>Zweites Volumen: {}</translation>
    </message>
    <message>
        <source>Nothing says that the positions of the second volume are the study&apos;s: not both have a frame of reference. Register both by --registration search.</source>
        <translation>Nichts sagt, dass die Positionen des zweiten Volumens die der Studie sind: nicht beide haben ein Bezugssystem. Registrieren Sie beide mit --registration search.</translation>
    </message>
    <message>
        <source>The second volume has another frame of reference than the study: its positions are not the study&apos;s. Register both by --registration search.</source>
        <translation>Das zweite Volumen hat ein anderes Bezugssystem als die Studie: seine Positionen sind nicht die der Studie. Registrieren Sie beide mit --registration search.</translation>
    </message>
    <message>
        <source>The second volume fits the study nearly as well {:.0f} mm from where it was registered, as a spine does one vertebra off.</source>
        <translation>Das zweite Volumen passt {:.0f} mm neben der registrierten Stelle fast ebenso gut zur Studie, wie eine Wirbelsäule um einen Wirbel verschoben.</translation>
    </message>
    <message>
        <source>The registration of the second volume is doubtful: look at both on slices before you rely on the picture.</source>
        <translation>Die Registrierung des zweiten Volumens ist zweifelhaft: sehen Sie beide auf Schichten an, bevor Sie sich auf das Bild verlassen.</translation>
    </message>
    <message>
        <source>The view was saved when the images of the study or of the second volume had other values or positions, or by an older Macula: where it lies there is not believed.</source>
        <translation>Die Ansicht wurde gespeichert, als die Bilder der Studie oder des zweiten Volumens andere Werte oder Positionen hatten, oder von einem älteren Macula: der Lage darin wird nicht geglaubt.</translation>
    </message>
    <message>
        <source>phantom</source>
        <translation>Phantom</translation>
    </message>
    <message>
        <source>images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>no study date</source>
        <translation>kein Studiendatum</translation>
    </message>
    <message>
        <source>series {}</source>
        <translation>Serie {}</translation>
    </message>
    <message>
        <source>volume {} of {}</source>
        <translation>Volumen {} von {}</translation>
    </message>
    <message>
        <source>one segment alone</source>
        <translation>ein Segment allein</translation>
    </message>
    <message>
        <source>some segments alone</source>
        <translation>einige Segmente allein</translation>
    </message>
    <message>
        <source>a segment left out</source>
        <translation>ein Segment weggelassen</translation>
    </message>
    <message>
        <source>some segments left out</source>
        <translation>einige Segmente weggelassen</translation>
    </message>
    <message>
        <source>Segmentation: {}</source>
        <translation>Segmentierung: {}</translation>
    </message>
    <message>
        <source>at most {} bytes</source>
        <translation>höchstens {} Bytes</translation>
    </message>
    <message>
        <source>a name</source>
        <translation>ein Name</translation>
    </message>
    <message>
        <source>&quot;LINEAR&quot;, &quot;LINEAR_EXACT&quot; or &quot;SIGMOID&quot;</source>
        <translation>„LINEAR“, „LINEAR_EXACT“ oder „SIGMOID“</translation>
    </message>
    <message>
        <source>pairs of numbers</source>
        <translation>Zahlenpaare</translation>
    </message>
    <message>
        <source>a camera, and an outline that encloses something</source>
        <translation>eine Kamera und ein Umriss, der etwas umschließt</translation>
    </message>
    <message>
        <source>1 to {} bytes</source>
        <translation>1 bis {} Bytes</translation>
    </message>
    <message>
        <source>one of {}</source>
        <translation>eines von {}</translation>
    </message>
    <message>
        <source>a rotation and a shift, row by row</source>
        <translation>eine Drehung und eine Verschiebung, Zeile für Zeile</translation>
    </message>
    <message>
        <source>the digest of a series</source>
        <translation>die Prüfsumme einer Serie</translation>
    </message>
    <message>
        <source>the digest of a volume</source>
        <translation>die Prüfsumme eines Volumens</translation>
    </message>
    <message>
        <source>the digest of two volumes</source>
        <translation>die Prüfsumme zweier Volumen</translation>
    </message>
    <message>
        <source>64 hexadecimal digits</source>
        <translation>64 hexadezimale Ziffern</translation>
    </message>
    <message>
        <source>a direction perpendicular to &quot;right&quot;</source>
        <translation>eine Richtung senkrecht zu „right“</translation>
    </message>
    <message>
        <source>a colour as #rrggbb</source>
        <translation>eine Farbe als #rrggbb</translation>
    </message>
    <message>
        <source>1 part</source>
        <translation>1 Teil</translation>
    </message>
    <message>
        <source>{} parts</source>
        <translation>{} Teile</translation>
    </message>
    <message>
        <source>{:.0f} mL</source>
        <translation>{:.0f} mL</translation>
    </message>
    <message>
        <source>≈ {:.0f} mL, not calibrated</source>
        <translation>≈ {:.0f} mL, nicht kalibriert</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>moderate</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>Something of that name is there already.</source>
        <translation>Etwas mit diesem Namen ist schon da.</translation>
    </message>
    <message>
        <source>An export cannot be in the folder of the stored sessions itself.</source>
        <translation>Ein Export kann nicht im Ordner der gespeicherten Sitzungen selbst liegen.</translation>
    </message>
    <message>
        <source>Make the folder writable for you, or choose another one.</source>
        <translation>Machen Sie den Ordner für sich beschreibbar, oder wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>Free some space on that disk; what was stored before is unharmed.</source>
        <translation>Schaffen Sie Platz auf dem Datenträger; früher Gespeichertes ist unversehrt.</translation>
    </message>
    <message>
        <source>Choose a folder on a local disk, or have locks switched on for that network drive.</source>
        <translation>Wählen Sie einen Ordner auf einem lokalen Datenträger, oder lassen Sie Sperren für das Netzlaufwerk einschalten.</translation>
    </message>
    <message>
        <source>Wait a moment and try again, or close other windows of Macula.</source>
        <translation>Warten Sie kurz und versuchen Sie es noch einmal, oder schließen Sie andere Fenster von Macula.</translation>
    </message>
    <message>
        <source>Close all windows of Macula and start it again: it rescues what can be read, and keeps the file.</source>
        <translation>Schließen Sie alle Fenster von Macula und starten Sie es neu: es rettet, was lesbar ist, und behält die Datei.</translation>
    </message>
    <message>
        <source>Use that version, or choose another folder. Nothing was changed.</source>
        <translation>Verwenden Sie diese Version, oder wählen Sie einen anderen Ordner. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Choose an empty folder, or one that Macula made. Nothing was changed.</source>
        <translation>Wählen Sie einen leeren Ordner oder einen von Macula. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Have the disk checked, or choose a folder on another one.</source>
        <translation>Lassen Sie den Datenträger prüfen, oder wählen Sie einen Ordner auf einem anderen.</translation>
    </message>
    <message>
        <source>Close other programs and try again.</source>
        <translation>Schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Nothing has to be done: the model is learnt anew.</source>
        <translation>Es ist nichts zu tun: das Modell wird neu gelernt.</translation>
    </message>
    <message>
        <source>Raise the limit for stored models.</source>
        <translation>Erhöhen Sie die Grenze für gespeicherte Modelle.</translation>
    </message>
    <message>
        <source>Make the setting once more.</source>
        <translation>Machen Sie die Einstellung noch einmal.</translation>
    </message>
    <message>
        <source>Check that it has a name of at most 200 bytes, and is a JSON object of at most 8 MB and 64 levels.</source>
        <translation>Prüfen Sie, ob es einen Namen von höchstens 200 Bytes hat und ein JSON-Objekt von höchstens 8 MB und 64 Ebenen ist.</translation>
    </message>
    <message>
        <source>Choose a folder that the export of sessions made.</source>
        <translation>Wählen Sie einen Ordner, den der Export von Sitzungen angelegt hat.</translation>
    </message>
    <message>
        <source>Close other windows of Macula and delete the same once more.</source>
        <translation>Schließen Sie andere Fenster von Macula, und löschen Sie dasselbe noch einmal.</translation>
    </message>
    <message>
        <source>It does not lie on the voxels of the images it was drawn on: it is on a grid of its own.</source>
        <translation>Sie liegt nicht auf den Voxeln der Bilder, auf denen sie gezeichnet wurde: sie ist auf einem eigenen Gitter.</translation>
    </message>
    <message>
        <source>The images it was drawn on are not there: it is on a grid of its own.</source>
        <translation>Die Bilder, auf denen sie gezeichnet wurde, fehlen: sie ist auf einem eigenen Gitter.</translation>
    </message>
    <message>
        <source>1 image</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>{} images</source>
        <translation>{} Bilder</translation>
    </message>
    <message>
        <source>The images are no volume.</source>
        <translation>Die Bilder sind kein Volumen.</translation>
    </message>
    <message>
        <source>There are no images in this series.</source>
        <translation>In dieser Serie sind keine Bilder.</translation>
    </message>
    <message>
        <source>{:.3g} × {:.3g} × {:.3g} mm</source>
        <translation>{:.3g} × {:.3g} × {:.3g} mm</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
    <message>
        <source>Patient {}</source>
        <translation>Patient {}</translation>
    </message>
    <message>
        <source>1 series</source>
        <translation>1 Serie</translation>
    </message>
    <message>
        <source>{} series</source>
        <translation>{} Serien</translation>
    </message>
    <message>
        <source>Series without a number</source>
        <translation>Serie ohne Nummer</translation>
    </message>
    <message>
        <source>Series {}: {}</source>
        <translation>Serie {}: {}</translation>
    </message>
    <message>
        <source>Series without a number: {}</source>
        <translation>Serie ohne Nummer: {}</translation>
    </message>
    <message>
        <source>no images</source>
        <translation>keine Bilder</translation>
    </message>
    <message>
        <source>{} so far</source>
        <translation>bisher {}</translation>
    </message>
    <message>
        <source>1 object</source>
        <translation>1 Objekt</translation>
    </message>
    <message>
        <source>{} objects</source>
        <translation>{} Objekte</translation>
    </message>
    <message>
        <source>1 volume</source>
        <translation>1 Volumen</translation>
    </message>
    <message>
        <source>{} volumes</source>
        <translation>{} Volumen</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>View of slices</source>
        <translation>Ansicht von Schichten</translation>
    </message>
    <message>
        <source>Stack {}</source>
        <translation>Stapel {}</translation>
    </message>
    <message>
        <source>phase {} of {}</source>
        <translation>Phase {} von {}</translation>
    </message>
    <message>
        <source>1 file left out</source>
        <translation>1 Datei weggelassen</translation>
    </message>
    <message>
        <source>{} files left out</source>
        <translation>{} Dateien weggelassen</translation>
    </message>
    <message>
        <source>Modality unknown</source>
        <translation>Modalität unbekannt</translation>
    </message>
    <message>
        <source>series without a number</source>
        <translation>Serie ohne Nummer</translation>
    </message>
    <message>
        <source>no description</source>
        <translation>keine Beschreibung</translation>
    </message>
    <message>
        <source>series {}: {}</source>
        <translation>Serie {}: {}</translation>
    </message>
    <message>
        <source>series without a number: {}</source>
        <translation>Serie ohne Nummer: {}</translation>
    </message>
    <message>
        <source>The series that was asked for is not in this folder.</source>
        <translation>Die verlangte Serie ist nicht in diesem Ordner.</translation>
    </message>
    <message>
        <source>Several studies of this folder have the series that was asked for.</source>
        <translation>Mehrere Studien dieses Ordners haben die verlangte Serie.</translation>
    </message>
    <message>
        <source>The images of the file that was opened.</source>
        <translation>Die Bilder der geöffneten Datei.</translation>
    </message>
    <message>
        <source>{}: this is no image.</source>
        <translation>{}: das ist kein Bild.</translation>
    </message>
    <message>
        <source>No patient name</source>
        <translation>Kein Patientenname</translation>
    </message>
    <message>
        <source>No patient ID</source>
        <translation>Keine Patienten-ID</translation>
    </message>
    <message>
        <source>ID {}</source>
        <translation>ID {}</translation>
    </message>
    <message>
        <source>born {}</source>
        <translation>geboren {}</translation>
    </message>
    <message>
        <source>no patient ID</source>
        <translation>keine Patienten-ID</translation>
    </message>
    <message>
        <source>The series has 1 stack of images.</source>
        <translation>Die Serie hat 1 Bildstapel.</translation>
    </message>
    <message>
        <source>The series has {} stacks of images.</source>
        <translation>Die Serie hat {} Bildstapel.</translation>
    </message>
    <message>
        <source>This folder is of {}.</source>
        <translation>Dieser Ordner ist von {}.</translation>
    </message>
    <message>
        <source>Check that it is of the patient you mean; macula info lists all series.</source>
        <translation>Prüfen Sie, ob es der gemeinte Patient ist; macula info zählt alle Serien auf.</translation>
    </message>
    <message>
        <source>1 file was left out; macula info says why.</source>
        <translation>1 Datei wurde weggelassen; macula info sagt, warum.</translation>
    </message>
    <message>
        <source>{} files were left out; macula info says why.</source>
        <translation>{} Dateien wurden weggelassen; macula info sagt, warum.</translation>
    </message>
    <message>
        <source>Built-in phantom</source>
        <translation>Eingebautes Phantom</translation>
    </message>
    <message>
        <source>File {}</source>
        <translation>Datei {}</translation>
    </message>
    <message>
        <source>The volume that was chosen.</source>
        <translation>Das gewählte Volumen.</translation>
    </message>
    <message>
        <source>1 file was left out; the list of studies and `macula info` on the folder say why.</source>
        <translation>1 Datei wurde weggelassen; die Liste der Studien und `macula info` zum Ordner sagen, warum.</translation>
    </message>
    <message>
        <source>{} files were left out; the list of studies and `macula info` on the folder say why.</source>
        <translation>{} Dateien wurden weggelassen; die Liste der Studien und `macula info` zum Ordner sagen, warum.</translation>
    </message>
    <message>
        <source>Series {} ({} images) could not be opened: {}</source>
        <translation>Serie {} ({} Bilder) konnte nicht geöffnet werden: {}</translation>
    </message>
    <message>
        <source>A series without a number ({} images) could not be opened: {}</source>
        <translation>Eine Serie ohne Nummer ({} Bilder) konnte nicht geöffnet werden: {}</translation>
    </message>
    <message>
        <source>The best volume that can be opened.</source>
        <translation>Das beste Volumen, das sich öffnen lässt.</translation>
    </message>
    <message>
        <source>The best of the other volumes is shown instead.</source>
        <translation>Stattdessen wird das beste der anderen Volumen gezeigt.</translation>
    </message>
    <message>
        <source>The best of the other volumes is shown instead, which is of another patient.</source>
        <translation>Stattdessen wird das beste der anderen Volumen gezeigt, das von einem anderen Patienten ist.</translation>
    </message>
    <message>
        <source>open this study</source>
        <translation>diese Studie zu öffnen</translation>
    </message>
    <message>
        <source>{} more</source>
        <translation>{} weitere</translation>
    </message>
    <message>
        <source>patient {} has series {}</source>
        <translation>Patient {} hat Serie {}</translation>
    </message>
    <message>
        <source>The images that it is of are no volume.</source>
        <translation>Die Bilder dazu sind kein Volumen.</translation>
    </message>
    <message>
        <source>The series that it is of belongs to another patient.</source>
        <translation>Die Serie dazu gehört zu einem anderen Patienten.</translation>
    </message>
    <message>
        <source>The series that it is of is not in this folder.</source>
        <translation>Die Serie dazu ist nicht in diesem Ordner.</translation>
    </message>
    <message>
        <source>Macula does not show presentation states of this kind.</source>
        <translation>Macula zeigt Presentation States dieser Art nicht.</translation>
    </message>
    <message>
        <source>sagittal</source>
        <translation>sagittal</translation>
    </message>
    <message>
        <source>coronal</source>
        <translation>koronar</translation>
    </message>
    <message>
        <source>axial</source>
        <translation>axial</translation>
    </message>
    <message>
        <source>oblique sagittal</source>
        <translation>schräg sagittal</translation>
    </message>
    <message>
        <source>oblique coronal</source>
        <translation>schräg koronar</translation>
    </message>
    <message>
        <source>oblique axial</source>
        <translation>schräg axial</translation>
    </message>
    <message>
        <source>pixels {:.4g} × {:.4g} mm</source>
        <translation>Pixel {:.4g} × {:.4g} mm</translation>
    </message>
    <message>
        <source>at {}</source>
        <translation>bei {}</translation>
    </message>
    <message>
        <source>no localizer</source>
        <translation>kein Localizer</translation>
    </message>
    <message>
        <source>localizer</source>
        <translation>Localizer</translation>
    </message>
    <message>
        <source>no {}</source>
        <translation>ohne Angabe: {}</translation>
    </message>
    <message>
        <source>It is of another patient.</source>
        <translation>Sie ist von einem anderen Patienten.</translation>
    </message>
    <message>
        <source>It has no frames.</source>
        <translation>Sie hat keine Einzelbilder.</translation>
    </message>
    <message>
        <source>It lies in another coordinate system (frame of reference) than this volume.</source>
        <translation>Sie liegt in einem anderen Koordinatensystem (Frame of Reference) als dieses Volumen.</translation>
    </message>
    <message>
        <source>Nothing says that it lies in the coordinate system of this volume.</source>
        <translation>Nichts sagt, dass sie im Koordinatensystem dieses Volumens liegt.</translation>
    </message>
    <message>
        <source>It was drawn on another series of this coordinate system.</source>
        <translation>Sie wurde auf einer anderen Serie dieses Koordinatensystems gezeichnet.</translation>
    </message>
    <message>
        <source>read the segmentations</source>
        <translation>die Segmentierungen zu lesen</translation>
    </message>
    <message>
        <source>use controllers</source>
        <translation>Controller verwenden</translation>
    </message>
    <message>
        <source>follow the eyes</source>
        <translation>den Augen folgen</translation>
    </message>
    <message>
        <source>tell where hands are</source>
        <translation>sagen, wo Hände sind</translation>
    </message>
    <message>
        <source>tell where hands point</source>
        <translation>sagen, wohin Hände zeigen</translation>
    </message>
    <message>
        <source>tell what hands do</source>
        <translation>sagen, was Hände tun</translation>
    </message>
    <message>
        <source>be felt in a hand</source>
        <translation>in der Hand zu spüren sein</translation>
    </message>
    <message>
        <source>keep pictures of that size</source>
        <translation>Bilder dieser Größe halten</translation>
    </message>
    <message>
        <source>lend its pictures</source>
        <translation>seine Bilder leihen</translation>
    </message>
    <message>
        <source>lend a picture</source>
        <translation>ein Bild leihen</translation>
    </message>
    <message>
        <source>take a picture back</source>
        <translation>ein Bild zurücknehmen</translation>
    </message>
    <message>
        <source>answer</source>
        <translation>antworten</translation>
    </message>
    <message>
        <source>tell what it offers</source>
        <translation>sagen, was es kann</translation>
    </message>
    <message>
        <source>be reached through its software</source>
        <translation>über seine Software erreicht werden</translation>
    </message>
    <message>
        <source>tell the name of its software</source>
        <translation>den Namen seiner Software sagen</translation>
    </message>
    <message>
        <source>be found</source>
        <translation>gefunden werden</translation>
    </message>
    <message>
        <source>tell its name</source>
        <translation>seinen Namen sagen</translation>
    </message>
    <message>
        <source>show a picture to each eye</source>
        <translation>jedem Auge ein Bild zeigen</translation>
    </message>
    <message>
        <source>tell how it shows pictures</source>
        <translation>sagen, wie es Bilder zeigt</translation>
    </message>
    <message>
        <source>name its controls</source>
        <translation>seine Bedienelemente nennen</translation>
    </message>
    <message>
        <source>tell which Vulkan it needs</source>
        <translation>sagen, welches Vulkan es braucht</translation>
    </message>
    <message>
        <source>tell which graphics device it is connected to</source>
        <translation>sagen, an welche Grafikkarte es angeschlossen ist</translation>
    </message>
    <message>
        <source>open its graphics device</source>
        <translation>seine Grafikkarte öffnen</translation>
    </message>
    <message>
        <source>begin a session</source>
        <translation>eine Sitzung beginnen</translation>
    </message>
    <message>
        <source>tell which spaces it knows</source>
        <translation>sagen, welche Räume es kennt</translation>
    </message>
    <message>
        <source>find its place</source>
        <translation>seinen Ort finden</translation>
    </message>
    <message>
        <source>tell what it does</source>
        <translation>sagen, was es tut</translation>
    </message>
    <message>
        <source>go on</source>
        <translation>weitermachen</translation>
    </message>
    <message>
        <source>begin to show pictures</source>
        <translation>beginnen, Bilder zu zeigen</translation>
    </message>
    <message>
        <source>stop showing pictures</source>
        <translation>aufhören, Bilder zu zeigen</translation>
    </message>
    <message>
        <source>tell what its lenses show</source>
        <translation>sagen, was seine Linsen zeigen</translation>
    </message>
    <message>
        <source>end the session</source>
        <translation>die Sitzung beenden</translation>
    </message>
    <message>
        <source>tell when it shows a picture</source>
        <translation>sagen, wann es ein Bild zeigt</translation>
    </message>
    <message>
        <source>begin a picture</source>
        <translation>ein Bild beginnen</translation>
    </message>
    <message>
        <source>tell where the eyes are</source>
        <translation>sagen, wo die Augen sind</translation>
    </message>
    <message>
        <source>show a picture</source>
        <translation>ein Bild zeigen</translation>
    </message>
    <message>
        <source>{}: {} frames in {:.1f} s, {:.1f} a second; {} without pictures.</source>
        <translation>{}: {} Bilder in {:.1f} s, {:.1f} in der Sekunde; {} davon leer.</translation>
    </message>
    <message>
        <source>This headset cannot show the room behind the anatomy.</source>
        <translation>Dieses Headset kann den Raum hinter der Anatomie nicht zeigen.</translation>
    </message>
    <message>
        <source>{} It is begun again.</source>
        <translation>{} Sie wird noch einmal begonnen.</translation>
    </message>
    <message>
        <source>Nothing was written.</source>
        <translation>Nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Pictures that were taken stay.</source>
        <translation>Aufgenommene Bilder bleiben.</translation>
    </message>
    <message>
        <source>tell which pictures it takes</source>
        <translation>sagen, welche Bilder es nimmt</translation>
    </message>
    <message>
        <source>tell whether it sees hands</source>
        <translation>sagen, ob es Hände sieht</translation>
    </message>
    <message>
        <source>follow hands</source>
        <translation>Händen folgen</translation>
    </message>
    <message>
        <source>Resting, drawn otherwise</source>
        <translation>In Ruhe, anders gezeichnet</translation>
    </message>
    <message>
        <source>Resting</source>
        <translation>In Ruhe</translation>
    </message>
    <message>
        <source>stack {}</source>
        <translation>Stapel {}</translation>
    </message>
    <message>
        <source>repetition {}</source>
        <translation>Wiederholung {}</translation>
    </message>
    <message>
        <source>copy {}</source>
        <translation>Kopie {}</translation>
    </message>
    <message>
        <source>acquisition {}</source>
        <translation>Aufnahme {}</translation>
    </message>
    <message>
        <source>contrast agent {}</source>
        <translation>Kontrastmittel {}</translation>
    </message>
    <message>
        <source>made by {}</source>
        <translation>Hersteller {}</translation>
    </message>
    <message>
        <source>kernel {}</source>
        <translation>Kernel {}</translation>
    </message>
    <message>
        <source>{} kV</source>
        <translation>{} kV</translation>
    </message>
    <message>
        <source>gantry tilted by {}°</source>
        <translation>Gantry um {}° geneigt</translation>
    </message>
    <message>
        <source>field of view {} mm</source>
        <translation>FOV {} mm</translation>
    </message>
    <message>
        <source>slices {} mm thick</source>
        <translation>Schichtdicke {} mm</translation>
    </message>
    <message>
        <source>TE {} ms</source>
        <translation>TE {} ms</translation>
    </message>
    <message>
        <source>echo {}</source>
        <translation>Echo {}</translation>
    </message>
    <message>
        <source>TR {} ms</source>
        <translation>TR {} ms</translation>
    </message>
    <message>
        <source>TI {} ms</source>
        <translation>TI {} ms</translation>
    </message>
    <message>
        <source>flip angle {}°</source>
        <translation>Flipwinkel {}°</translation>
    </message>
    <message>
        <source>b {} s/mm²</source>
        <translation>b {} s/mm²</translation>
    </message>
    <message>
        <source>sequence {}</source>
        <translation>Sequenz {}</translation>
    </message>
    <message>
        <source>trigger time {} ms</source>
        <translation>Triggerzeit {} ms</translation>
    </message>
    <message>
        <source>time point {}</source>
        <translation>Zeitpunkt {}</translation>
    </message>
    <message>
        <source>{} % of the heartbeat</source>
        <translation>{} % des Herzschlags</translation>
    </message>
    <message>
        <source>{} % of the breath</source>
        <translation>{} % des Atemzugs</translation>
    </message>
    <message>
        <source>frame at {} ms</source>
        <translation>Frame bei {} ms</translation>
    </message>
    <message>
        <source>bounces</source>
        <translation>Streuungen</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>light rotation</source>
        <translation>Drehung der Lichter</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>light strength</source>
        <translation>Stärke der Lichter</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>surface gradient</source>
        <translation>Gradient der Oberfläche</translation>
    </message>
    <message>
        <source>per mm</source>
        <translation>je mm</translation>
    </message>
    <message>
        <source>roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>reflectance</source>
        <translation>Reflexionsgrad</translation>
    </message>
    <message>
        <source>anisotropy</source>
        <translation>Anisotropie</translation>
    </message>
    <message>
        <source>steep gradient</source>
        <translation>Gradient des Steilen</translation>
    </message>
    <message>
        <source>Part of the light that the steepest boundary scatters like a rough, wet surface</source>
        <translation>Teil des Lichts, den die steilste Grenze wie eine raue, nasse Oberfläche streut</translation>
    </message>
    <message>
        <source>Steepness of a boundary that is half a surface, in values per mm</source>
        <translation>Steilheit einer Grenze, die halb Oberfläche ist, in Werten je mm</translation>
    </message>
    <message>
        <source>Of surfaces: highlights are smaller and brighter where it is less</source>
        <translation>Von Oberflächen: Je kleiner, desto kleiner und heller sind Glanzlichter</translation>
    </message>
    <message>
        <source>Of surfaces: the part that they reflect of light which falls straight</source>
        <translation>Von Oberflächen: der Teil senkrecht einfallenden Lichts, den sie spiegeln</translation>
    </message>
    <message>
        <source>Of what scatters like a cloud: above 0 light goes on forwards, below 0 it comes back</source>
        <translation>Von dem, was wie eine Wolke streut: Über 0 läuft Licht nach vorn weiter, unter 0 kommt es zurück</translation>
    </message>
    <message>
        <source>Of presets with curves for steep matter: where half of the matter is steep, in values per mm</source>
        <translation>Bei Voreinstellungen mit Kurven für steile Materie: ab wo die Hälfte der Materie steil ist, in Werten je mm</translation>
    </message>
    <message>
        <source>The graphics device stopped responding; the work begins anew on a new one.</source>
        <translation>Das Grafikgerät antwortet nicht mehr; die Arbeit beginnt auf einem neuen von vorn.</translation>
    </message>
    <message>
        <source>A ball is removed.</source>
        <translation>Eine Kugel ist entfernt.</translation>
    </message>
    <message>
        <source>Only a ball is kept.</source>
        <translation>Nur eine Kugel bleibt.</translation>
    </message>
    <message>
        <source>Remove a ball</source>
        <translation>Kugel entfernen</translation>
    </message>
    <message>
        <source>Removes a ball around the cross-hair; it takes the place of another ball</source>
        <translation>Entfernt eine Kugel um das Fadenkreuz; sie ersetzt eine andere Kugel</translation>
    </message>
    <message>
        <source>Radius of the ball</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source>From its centre, in mm</source>
        <translation>Von der Mitte aus, in mm</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>A corner is removed.</source>
        <translation>Eine Ecke ist entfernt.</translation>
    </message>
    <message>
        <source>A box is removed.</source>
        <translation>Ein Quader ist entfernt.</translation>
    </message>
    <message>
        <source>Only a turned box is kept.</source>
        <translation>Nur ein gedrehter Quader bleibt.</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>run &quot;{}&quot;</source>
        <translation>„{}“ ausführen</translation>
    </message>
    <message>
        <source>Check that it exists, and that you may read it.</source>
        <translation>Prüfen Sie, ob es sie gibt und ob Sie sie lesen dürfen.</translation>
    </message>
    <message>
        <source>The file does not begin as a DICOM file does.</source>
        <translation>Die Datei beginnt nicht so wie eine DICOM-Datei.</translation>
    </message>
    <message>
        <source>Choose files of DICOM with file meta information.</source>
        <translation>Wählen Sie DICOM-Dateien mit Metainformation (File Meta Information).</translation>
    </message>
    <message>
        <source>This machine could not make a connection.</source>
        <translation>Dieser Rechner konnte keine Verbindung herstellen.</translation>
    </message>
    <message>
        <source>Images come over the same connection (C-GET).</source>
        <translation>Bilder kommen über dieselbe Verbindung (C-GET).</translation>
    </message>
    <message>
        <source>The archive can only send to a receiver, and this program has none set up.</source>
        <translation>Das Archiv kann nur an einen Empfänger senden, und für dieses Programm ist keiner eingerichtet.</translation>
    </message>
    <message>
        <source>Enter a receiver&apos;s port in the settings of the archive, and ask the administrator of the archive to add the receiver&apos;s AE title with the host name and this port of this machine.</source>
        <translation>Geben Sie in den Einstellungen des Archivs den Port eines Empfängers ein, und bitten Sie die Verwaltung des Archivs, den AE-Titel des Empfängers mit dem Rechnernamen und diesem Port dieses Rechners einzutragen.</translation>
    </message>
    <message>
        <source>The archive sends images to {} at port {} of this machine (C-MOVE).</source>
        <translation>Das Archiv sendet Bilder an {} am Port {} dieses Rechners (C-MOVE).</translation>
    </message>
    <message>
        <source>Testing the connection</source>
        <translation>Die Verbindung wird geprüft</translation>
    </message>
    <message>
        <source>Host name</source>
        <translation>Rechnername</translation>
    </message>
    <message>
        <source>The host name is known.</source>
        <translation>Der Rechnername ist bekannt.</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Somebody answers at port {}.</source>
        <translation>Am Port {} antwortet jemand.</translation>
    </message>
    <message>
        <source>Protected connection</source>
        <translation>Geschützte Verbindung</translation>
    </message>
    <message>
        <source>The connection is encrypted, and the archive&apos;s certificate is trusted.</source>
        <translation>Die Verbindung ist verschlüsselt, und dem Zertifikat des Archivs wird vertraut.</translation>
    </message>
    <message>
        <source>AE titles</source>
        <translation>AE-Titel</translation>
    </message>
    <message>
        <source>The archive accepts {} as the AE title of this program.</source>
        <translation>Das Archiv akzeptiert {} als AE-Titel dieses Programms.</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>The archive answers.</source>
        <translation>Das Archiv antwortet.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>The archive lets this program search.</source>
        <translation>Das Archiv lässt dieses Programm suchen.</translation>
    </message>
    <message>
        <source>Retrieval</source>
        <translation>Abruf</translation>
    </message>
    <message>
        <source>To be sent instances over protected connections, this program needs a certificate.</source>
        <translation>Damit ihm über geschützte Verbindungen Instanzen gesendet werden, braucht dieses Programm ein Zertifikat.</translation>
    </message>
    <message>
        <source>Enter one with its key in the settings of the archive, or fetch with C-GET.</source>
        <translation>Geben Sie eines mit seinem Schlüssel in den Einstellungen des Archivs ein, oder rufen Sie mit C-GET ab.</translation>
    </message>
    <message>
        <source>Searching the archive</source>
        <translation>Das Archiv wird durchsucht</translation>
    </message>
    <message>
        <source>Asking the archive for series</source>
        <translation>Das Archiv wird nach den Serien gefragt</translation>
    </message>
    <message>
        <source>Asking the archive for images</source>
        <translation>Das Archiv wird nach den Bildern gefragt</translation>
    </message>
    <message>
        <source>An AE title has 1 to 16 letters, digits and signs, without accents.</source>
        <translation>Ein AE-Titel hat 1 bis 16 Buchstaben, Ziffern und Zeichen, ohne Umlaute und Akzente.</translation>
    </message>
    <message>
        <source>The archive has no host name that could be looked for.</source>
        <translation>Das Archiv hat keinen Rechnernamen, nach dem gesucht werden könnte.</translation>
    </message>
    <message>
        <source>Enter a host name or an IP address alone, without a port.</source>
        <translation>Geben Sie nur einen Rechnernamen oder eine IP-Adresse ein, ohne Port.</translation>
    </message>
    <message>
        <source>The archive has no port.</source>
        <translation>Das Archiv hat keinen Port.</translation>
    </message>
    <message>
        <source>Enter a number from 1 to 65535.</source>
        <translation>Geben Sie eine Zahl von 1 bis 65535 ein.</translation>
    </message>
    <message>
        <source>The archive&apos;s AE title is not valid.</source>
        <translation>Der AE-Titel des Archivs ist kein gültiger.</translation>
    </message>
    <message>
        <source>The AE title of this program is not valid.</source>
        <translation>Der AE-Titel dieses Programms ist kein gültiger.</translation>
    </message>
    <message>
        <source>The AE title of this program&apos;s receiver is not valid.</source>
        <translation>Der AE-Titel des Empfängers dieses Programms ist kein gültiger.</translation>
    </message>
    <message>
        <source>Fetching by C-MOVE needs a port at which this program receives.</source>
        <translation>Der Abruf mit C-MOVE braucht einen Port, an dem dieses Programm empfängt.</translation>
    </message>
    <message>
        <source>Enter a receiver&apos;s port, or let the program choose how to fetch.</source>
        <translation>Geben Sie den Port eines Empfängers ein, oder lassen Sie das Programm wählen, wie es abruft.</translation>
    </message>
    <message>
        <source>There is a key, but no certificate that it belongs to.</source>
        <translation>Es gibt einen Schlüssel, aber kein Zertifikat, zu dem er gehört.</translation>
    </message>
    <message>
        <source>Enter the certificate of this program too.</source>
        <translation>Geben Sie auch das Zertifikat dieses Programms ein.</translation>
    </message>
    <message>
        <source>No machine is known by the host name of this archive.</source>
        <translation>Unter dem Rechnernamen dieses Archivs ist kein Rechner bekannt.</translation>
    </message>
    <message>
        <source>Check how the host name is written, or enter the archive&apos;s IP address.</source>
        <translation>Prüfen Sie, wie der Rechnername geschrieben ist, oder geben Sie die IP-Adresse des Archivs ein.</translation>
    </message>
    <message>
        <source>The archive&apos;s machine is there, but nothing answers at this port.</source>
        <translation>Der Rechner des Archivs ist da, aber an diesem Port antwortet nichts.</translation>
    </message>
    <message>
        <source>Check the port number, and ask the administrator of the archive whether its DICOM service is on.</source>
        <translation>Prüfen Sie die Nummer des Ports, und fragen Sie die Verwaltung des Archivs, ob sein DICOM-Dienst läuft.</translation>
    </message>
    <message>
        <source>The archive&apos;s machine cannot be reached from here.</source>
        <translation>Der Rechner des Archivs ist von hier aus nicht zu erreichen.</translation>
    </message>
    <message>
        <source>Check the host name and the network, or whether a VPN is needed.</source>
        <translation>Prüfen Sie den Rechnernamen und das Netz, oder ob ein VPN nötig ist.</translation>
    </message>
    <message>
        <source>The archive&apos;s machine did not answer in time.</source>
        <translation>Der Rechner des Archivs hat nicht rechtzeitig geantwortet.</translation>
    </message>
    <message>
        <source>Check host name and port. A firewall in between may block this port.</source>
        <translation>Prüfen Sie Rechnernamen und Port. Vielleicht sperrt eine Firewall dazwischen diesen Port.</translation>
    </message>
    <message>
        <source>The archive took the connection and then did not answer in time.</source>
        <translation>Das Archiv hat die Verbindung angenommen und dann nicht rechtzeitig geantwortet.</translation>
    </message>
    <message>
        <source>Try again later. If the archive is only slow, allow it more time.</source>
        <translation>Versuchen Sie es später noch einmal. Wenn das Archiv nur langsam ist, geben Sie ihm mehr Zeit.</translation>
    </message>
    <message>
        <source>The archive closed the connection before it was done.</source>
        <translation>Das Archiv hat die Verbindung geschlossen, bevor es fertig war.</translation>
    </message>
    <message>
        <source>Try again. If this goes on, ask the administrator of the archive what its log says.</source>
        <translation>Versuchen Sie es noch einmal. Wenn das so bleibt, fragen Sie die Verwaltung des Archivs, was sein Protokoll sagt.</translation>
    </message>
    <message>
        <source>The archive closed the connection without an answer.</source>
        <translation>Das Archiv hat die Verbindung ohne Antwort geschlossen.</translation>
    </message>
    <message>
        <source>Check whether this port expects TLS, and whether it is that of the archive&apos;s DICOM service.</source>
        <translation>Prüfen Sie, ob dieser Port TLS erwartet und ob er der des DICOM-Dienstes des Archivs ist.</translation>
    </message>
    <message>
        <source>What answered does not speak DICOM as the standard says.</source>
        <translation>Was geantwortet hat, spricht kein DICOM, wie es der Standard verlangt.</translation>
    </message>
    <message>
        <source>Check that the port is that of the archive&apos;s DICOM service, and whether it expects TLS.</source>
        <translation>Prüfen Sie, ob der Port der des DICOM-Dienstes des Archivs ist und ob er TLS erwartet.</translation>
    </message>
    <message>
        <source>The archive does not know the kind of connection that DICOM prescribes.</source>
        <translation>Das Archiv kennt die Art der Verbindung nicht, die DICOM vorschreibt.</translation>
    </message>
    <message>
        <source>Check that the port is that of the archive&apos;s DICOM service.</source>
        <translation>Prüfen Sie, ob der Port der des DICOM-Dienstes des Archivs ist.</translation>
    </message>
    <message>
        <source>The archive does not know this program by the AE title {}.</source>
        <translation>Das Archiv kennt dieses Programm nicht unter dem AE-Titel {}.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive to add this AE title with the address of this machine, or enter the title that is known there.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, diesen AE-Titel mit der Adresse dieses Rechners einzutragen, oder geben Sie den Titel ein, der dort bekannt ist.</translation>
    </message>
    <message>
        <source>The archive does not go by the AE title {}.</source>
        <translation>Das Archiv hat einen anderen AE-Titel als {}.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive for its AE title. Capitals matter.</source>
        <translation>Fragen Sie die Verwaltung des Archivs nach seinem AE-Titel. Auf Groß- und Kleinschreibung kommt es an.</translation>
    </message>
    <message>
        <source>The archive does not speak this version of the DICOM protocol.</source>
        <translation>Das Archiv spricht diese Version des DICOM-Protokolls nicht.</translation>
    </message>
    <message>
        <source>The archive is busy and takes no more connections now.</source>
        <translation>Das Archiv ist ausgelastet und nimmt jetzt keine weiteren Verbindungen an.</translation>
    </message>
    <message>
        <source>Try again in a few minutes.</source>
        <translation>Versuchen Sie es in ein paar Minuten noch einmal.</translation>
    </message>
    <message>
        <source>The archive has as many connections as it allows.</source>
        <translation>Das Archiv hat so viele Verbindungen, wie es erlaubt.</translation>
    </message>
    <message>
        <source>Try again when others have ended theirs, or ask the administrator of the archive to allow more.</source>
        <translation>Versuchen Sie es noch einmal, wenn andere ihre beendet haben, oder bitten Sie die Verwaltung des Archivs, mehr zu erlauben.</translation>
    </message>
    <message>
        <source>The archive refused the connection temporarily, and gave no reason.</source>
        <translation>Das Archiv hat die Verbindung vorerst abgelehnt, ohne einen Grund zu nennen.</translation>
    </message>
    <message>
        <source>The archive refused the connection without a reason.</source>
        <translation>Das Archiv hat die Verbindung abgelehnt, ohne einen Grund zu nennen.</translation>
    </message>
    <message>
        <source>Check both AE titles, and ask the administrator of the archive what its log says.</source>
        <translation>Prüfen Sie beide AE-Titel, und fragen Sie die Verwaltung des Archivs, was sein Protokoll sagt.</translation>
    </message>
    <message>
        <source>The archive says that this instance does not fit its own kind (status {}).</source>
        <translation>Das Archiv sagt, dass diese Instanz nicht zu ihrer eigenen Art passt (Status {}).</translation>
    </message>
    <message>
        <source>The file may be damaged or against the standard. Ask the administrator of the archive.</source>
        <translation>Die Datei ist vielleicht beschädigt oder verstößt gegen den Standard. Fragen Sie die Verwaltung des Archivs.</translation>
    </message>
    <message>
        <source>The archive could not take this instance (status {}).</source>
        <translation>Das Archiv konnte diese Instanz nicht annehmen (Status {}).</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive what its log says.</source>
        <translation>Fragen Sie die Verwaltung des Archivs, was sein Protokoll sagt.</translation>
    </message>
    <message>
        <source>The archive lacks the means to find out how much matches (status {}).</source>
        <translation>Dem Archiv fehlen die Mittel, um festzustellen, wie viel passt (Status {}).</translation>
    </message>
    <message>
        <source>Ask for less at once, or try again later.</source>
        <translation>Verlangen Sie weniger auf einmal, oder versuchen Sie es später noch einmal.</translation>
    </message>
    <message>
        <source>The archive could not send the instances (status {}).</source>
        <translation>Das Archiv konnte die Instanzen nicht senden (Status {}).</translation>
    </message>
    <message>
        <source>Check that the archive knows host and port of this program&apos;s receiver, and that no firewall blocks them.</source>
        <translation>Prüfen Sie, ob das Archiv Rechner und Port des Empfängers dieses Programms kennt und ob keine Firewall sie sperrt.</translation>
    </message>
    <message>
        <source>Try again later, or ask the administrator of the archive what its log says.</source>
        <translation>Versuchen Sie es später noch einmal, oder fragen Sie die Verwaltung des Archivs, was sein Protokoll sagt.</translation>
    </message>
    <message>
        <source>The archive lacks the means to do this now (status {}).</source>
        <translation>Dem Archiv fehlen jetzt die Mittel dafür (Status {}).</translation>
    </message>
    <message>
        <source>The archive does not know the AE title of this program&apos;s receiver (status {}).</source>
        <translation>Das Archiv kennt den AE-Titel des Empfängers dieses Programms nicht (Status {}).</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive to add the receiver&apos;s AE title with the host name and the port of this machine.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, den AE-Titel des Empfängers mit dem Rechnernamen und dem Port dieses Rechners einzutragen.</translation>
    </message>
    <message>
        <source>The archive does not offer this service (status {}).</source>
        <translation>Das Archiv bietet diesen Dienst nicht (Status {}).</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive to switch it on for this program.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, ihn für dieses Programm einzuschalten.</translation>
    </message>
    <message>
        <source>The archive does not allow this program to do this (status {}).</source>
        <translation>Das Archiv erlaubt diesem Programm das nicht (Status {}).</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive for the right to do this.</source>
        <translation>Bitten Sie die Verwaltung des Archivs um das Recht dazu.</translation>
    </message>
    <message>
        <source>The archive stopped by itself (status {}).</source>
        <translation>Das Archiv hat von selbst aufgehört (Status {}).</translation>
    </message>
    <message>
        <source>The archive did not understand the request (status {}).</source>
        <translation>Das Archiv hat die Anfrage nicht verstanden (Status {}).</translation>
    </message>
    <message>
        <source>The archive cannot search by what was asked (status {}).</source>
        <translation>Das Archiv kann nach dem Verlangten nicht suchen (Status {}).</translation>
    </message>
    <message>
        <source>Leave out some fields, or try the patient root model in the settings.</source>
        <translation>Lassen Sie einige Felder weg, oder versuchen Sie in den Einstellungen das Abfragemodell Patient Root.</translation>
    </message>
    <message>
        <source>The archive could not process the request (status {}).</source>
        <translation>Das Archiv konnte die Anfrage nicht verarbeiten (Status {}).</translation>
    </message>
    <message>
        <source>Ask for something simpler, or ask the administrator of the archive what its log says.</source>
        <translation>Verlangen Sie etwas Einfacheres, oder fragen Sie die Verwaltung des Archivs, was sein Protokoll sagt.</translation>
    </message>
    <message>
        <source>The archive failed for a reason of its own (status {}).</source>
        <translation>Das Archiv ist aus einem eigenen Grund gescheitert (Status {}).</translation>
    </message>
    <message>
        <source>Try again, or ask the administrator of the archive what its log says.</source>
        <translation>Versuchen Sie es noch einmal, oder fragen Sie die Verwaltung des Archivs, was sein Protokoll sagt.</translation>
    </message>
    <message>
        <source>The archive does not let this program search.</source>
        <translation>Das Archiv lässt dieses Programm nicht suchen.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive to allow C-FIND for this AE title, or try the other query model in the settings.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, C-FIND für diesen AE-Titel zu erlauben, oder versuchen Sie in den Einstellungen das andere Abfragemodell.</translation>
    </message>
    <message>
        <source>The archive does not let this program fetch over its own connection.</source>
        <translation>Das Archiv lässt dieses Programm nicht über dessen eigene Verbindung abrufen.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive to allow C-GET for this AE title, or set up a receiver&apos;s port here, and its AE title, host and port in the archive.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, C-GET für diesen AE-Titel zu erlauben, oder richten Sie hier den Port eines Empfängers ein und im Archiv dessen AE-Titel, Rechner und Port.</translation>
    </message>
    <message>
        <source>The archive does not let this program ask for instances to be sent.</source>
        <translation>Das Archiv lässt dieses Programm nicht verlangen, dass ihm Instanzen gesendet werden.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive to allow C-MOVE for this AE title.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, C-MOVE für diesen AE-Titel zu erlauben.</translation>
    </message>
    <message>
        <source>The archive takes no instances of this kind.</source>
        <translation>Das Archiv nimmt keine Instanzen dieser Art an.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive to allow storing for this AE title.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, das Speichern für diesen AE-Titel zu erlauben.</translation>
    </message>
    <message>
        <source>The archive does not answer to a test of the connection.</source>
        <translation>Das Archiv antwortet nicht auf eine Prüfung der Verbindung.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive to allow C-ECHO for this AE title.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, C-ECHO für diesen AE-Titel zu erlauben.</translation>
    </message>
    <message>
        <source>The archive has no images of what was asked for.</source>
        <translation>Das Archiv hat keine Bilder zu dem, was verlangt wurde.</translation>
    </message>
    <message>
        <source>Search again: they may have been moved or deleted.</source>
        <translation>Suchen Sie noch einmal: vielleicht wurden sie verschoben oder gelöscht.</translation>
    </message>
    <message>
        <source>Asking the archive which images there are</source>
        <translation>Das Archiv wird gefragt, welche Bilder es gibt</translation>
    </message>
    <message>
        <source>Fetching from the archive</source>
        <translation>Aus dem Archiv wird abgerufen</translation>
    </message>
    <message>
        <source>What is searched for cannot be written in this archive&apos;s character set.</source>
        <translation>Wonach gesucht wird, lässt sich im Zeichensatz dieses Archivs nicht schreiben.</translation>
    </message>
    <message>
        <source>Search with fewer special characters, or change the character set in the archive&apos;s settings.</source>
        <translation>Suchen Sie mit weniger Sonderzeichen, oder ändern Sie den Zeichensatz in den Einstellungen des Archivs.</translation>
    </message>
    <message>
        <source>An instance from the archive could not be written.</source>
        <translation>Eine Instanz aus dem Archiv konnte nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Make room on the disk, and fetch again: what has come is kept.</source>
        <translation>Schaffen Sie Platz auf dem Datenträger, und rufen Sie noch einmal ab: was gekommen ist, bleibt erhalten.</translation>
    </message>
    <message>
        <source>This machine has no means left to receive instances.</source>
        <translation>Dieser Rechner hat keine Mittel mehr, um Instanzen zu empfangen.</translation>
    </message>
    <message>
        <source>The archive does not take the encoding of this file.</source>
        <translation>Das Archiv nimmt die Kodierung dieser Datei nicht an.</translation>
    </message>
    <message>
        <source>Macula sends files as they are. Convert the file with other software, or ask the administrator of the archive to allow this transfer syntax.</source>
        <translation>Macula sendet Dateien, wie sie sind. Wandeln Sie die Datei mit anderer Software um, oder bitten Sie die Verwaltung des Archivs, diese Transfersyntax zu erlauben.</translation>
    </message>
    <message>
        <source>This file is cut off or damaged.</source>
        <translation>Diese Datei ist abgeschnitten oder beschädigt.</translation>
    </message>
    <message>
        <source>Get the file again from where it came from.</source>
        <translation>Holen Sie die Datei noch einmal von dort, woher sie kam.</translation>
    </message>
    <message>
        <source>The file does not name the object that it holds.</source>
        <translation>Die Datei nennt das Objekt nicht, das sie enthält.</translation>
    </message>
    <message>
        <source>Leave it out, or write it again with the program that made it.</source>
        <translation>Lassen Sie sie weg, oder schreiben Sie sie noch einmal mit dem Programm, das sie erstellt hat.</translation>
    </message>
    <message>
        <source>This file could not be read to its end.</source>
        <translation>Diese Datei konnte nicht bis zu ihrem Ende gelesen werden.</translation>
    </message>
    <message>
        <source>Check the disk, and whether somebody else changes the file.</source>
        <translation>Prüfen Sie den Datenträger, und ob jemand anderes die Datei ändert.</translation>
    </message>
    <message>
        <source>Sending to the archive</source>
        <translation>An das Archiv wird gesendet</translation>
    </message>
    <message>
        <source>The certificates of the authorities that are to be trusted cannot be read.</source>
        <translation>Die Zertifikate der Zertifizierungsstellen, denen vertraut werden soll, können nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Enter a PEM file, or a folder of hashed certificates.</source>
        <translation>Geben Sie eine PEM-Datei oder einen Ordner mit Zertifikaten unter ihren Hashwerten an.</translation>
    </message>
    <message>
        <source>The key of this program&apos;s certificate cannot be read.</source>
        <translation>Der Schlüssel zum Zertifikat dieses Programms kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Enter a PEM file, and its passphrase if it has one.</source>
        <translation>Geben Sie eine PEM-Datei an, und ihre Passphrase, wenn sie eine hat.</translation>
    </message>
    <message>
        <source>The certificate of this program cannot be read.</source>
        <translation>Das Zertifikat dieses Programms kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Enter a PEM file.</source>
        <translation>Geben Sie eine PEM-Datei an.</translation>
    </message>
    <message>
        <source>The key does not belong to this program&apos;s certificate.</source>
        <translation>Der Schlüssel gehört nicht zum Zertifikat dieses Programms.</translation>
    </message>
    <message>
        <source>Enter the key that was made together with the certificate.</source>
        <translation>Geben Sie den Schlüssel an, der zusammen mit dem Zertifikat erstellt wurde.</translation>
    </message>
    <message>
        <source>This machine&apos;s library for TLS cannot be used.</source>
        <translation>Die TLS-Bibliothek dieses Rechners kann nicht verwendet werden.</translation>
    </message>
    <message>
        <source>Ask whoever looks after this machine to update OpenSSL.</source>
        <translation>Bitten Sie die Systemverwaltung dieses Rechners, OpenSSL zu aktualisieren.</translation>
    </message>
    <message>
        <source>The certificate of the archive has expired.</source>
        <translation>Das Zertifikat des Archivs ist abgelaufen.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive to renew it, and check this machine&apos;s date.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, es zu erneuern, und prüfen Sie das Datum dieses Rechners.</translation>
    </message>
    <message>
        <source>The certificate of the archive is not valid yet.</source>
        <translation>Das Zertifikat des Archivs ist noch nicht gültig.</translation>
    </message>
    <message>
        <source>Check this machine&apos;s date and time.</source>
        <translation>Prüfen Sie Datum und Uhrzeit dieses Rechners.</translation>
    </message>
    <message>
        <source>The certificate of the archive is for another host name.</source>
        <translation>Das Zertifikat des Archivs gilt für einen anderen Rechnernamen.</translation>
    </message>
    <message>
        <source>Enter the host name that the certificate names; another one may be an impostor&apos;s.</source>
        <translation>Geben Sie den Rechnernamen ein, den das Zertifikat nennt; hinter einem anderen kann sich ein Betrüger verbergen.</translation>
    </message>
    <message>
        <source>The certificate of the archive has been revoked.</source>
        <translation>Das Zertifikat des Archivs wurde widerrufen.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive.</source>
        <translation>Fragen Sie die Verwaltung des Archivs.</translation>
    </message>
    <message>
        <source>The certificate of the archive is signed by nobody whom this machine trusts.</source>
        <translation>Das Zertifikat des Archivs ist von niemandem signiert, dem dieser Rechner vertraut.</translation>
    </message>
    <message>
        <source>Enter the certificate of the authority that signed it, which the administrator of the archive has.</source>
        <translation>Geben Sie das Zertifikat der Zertifizierungsstelle an, die es signiert hat; die Verwaltung des Archivs hat es.</translation>
    </message>
    <message>
        <source>The archive did not answer when a protected connection was to begin.</source>
        <translation>Das Archiv hat nicht geantwortet, als eine geschützte Verbindung beginnen sollte.</translation>
    </message>
    <message>
        <source>Check that this port of the archive is the one for TLS.</source>
        <translation>Prüfen Sie, ob dieser Port des Archivs der für TLS ist.</translation>
    </message>
    <message>
        <source>The archive does not use TLS at this port.</source>
        <translation>Das Archiv verwendet an diesem Port kein TLS.</translation>
    </message>
    <message>
        <source>Enter the port for TLS, or switch TLS off if the network is safe without.</source>
        <translation>Geben Sie den Port für TLS ein, oder schalten Sie TLS aus, wenn das Netz auch ohne sicher ist.</translation>
    </message>
    <message>
        <source>The archive and this program have no way of protecting a connection in common.</source>
        <translation>Das Archiv und dieses Programm haben kein gemeinsames Verfahren, um eine Verbindung zu schützen.</translation>
    </message>
    <message>
        <source>The archive must offer TLS 1.2 or later with the ciphers of BCP 195.</source>
        <translation>Das Archiv muss TLS 1.2 oder neuer mit den Verfahren von BCP 195 bieten.</translation>
    </message>
    <message>
        <source>The archive does not accept the certificate of this program.</source>
        <translation>Das Archiv akzeptiert das Zertifikat dieses Programms nicht.</translation>
    </message>
    <message>
        <source>Enter a certificate that the archive trusts, with its key.</source>
        <translation>Geben Sie ein Zertifikat, dem das Archiv vertraut, mit seinem Schlüssel an.</translation>
    </message>
    <message>
        <source>No protected connection to the archive could be made.</source>
        <translation>Es kam keine geschützte Verbindung zum Archiv zustande.</translation>
    </message>
    <message>
        <source>Check that this port of the archive is the one for TLS, and whether it asks for a certificate of this program.</source>
        <translation>Prüfen Sie, ob dieser Port des Archivs der für TLS ist und ob er ein Zertifikat dieses Programms verlangt.</translation>
    </message>
    <message>
        <source>docs/pacs.md shows how a file of archives is written.</source>
        <translation>docs/pacs.md zeigt, wie eine Datei mit Archiven geschrieben wird.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; has a value that does not fit it.</source>
        <translation>„{}“ hat einen Wert, der nicht dazu passt.</translation>
    </message>
    <message>
        <source>&quot;{}&quot; is not a setting of an archive.</source>
        <translation>„{}“ ist keine Einstellung eines Archivs.</translation>
    </message>
    <message>
        <source>An archive in the list is not an object.</source>
        <translation>Ein Archiv in der Liste ist kein Objekt.</translation>
    </message>
    <message>
        <source>An archive needs either &quot;dimse&quot; or &quot;dicomweb&quot;.</source>
        <translation>Ein Archiv braucht entweder „dimse“ oder „dicomweb“.</translation>
    </message>
    <message>
        <source>The name of an archive has 1 to 64 characters, and no slash.</source>
        <translation>Der Name eines Archivs hat 1 bis 64 Zeichen und keinen Schrägstrich.</translation>
    </message>
    <message>
        <source>The file of archives is not JSON.</source>
        <translation>Die Datei mit den Archiven ist kein JSON.</translation>
    </message>
    <message>
        <source>The file of archives lacks its version (1) or its list of sources.</source>
        <translation>Der Datei mit den Archiven fehlt ihre Version (1) oder ihre Liste der Quellen.</translation>
    </message>
    <message>
        <source>Two archives in the list have the same name.</source>
        <translation>Zwei Archive in der Liste haben denselben Namen.</translation>
    </message>
    <message>
        <source>The folder for the list of archives cannot be made.</source>
        <translation>Der Ordner für die Liste der Archive kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>Check the permissions of your data folder.</source>
        <translation>Prüfen Sie die Zugriffsrechte Ihres Datenordners.</translation>
    </message>
    <message>
        <source>The file cannot be made private.</source>
        <translation>Die Datei kann nicht vor anderen geschützt werden.</translation>
    </message>
    <message>
        <source>Choose a data folder on a disk with permissions: XDG_DATA_HOME names it.</source>
        <translation>Wählen Sie einen Datenordner auf einem Datenträger mit Zugriffsrechten: XDG_DATA_HOME nennt ihn.</translation>
    </message>
    <message>
        <source>Others can read the file with the passwords of archives.</source>
        <translation>Andere können die Datei mit den Passwörtern von Archiven lesen.</translation>
    </message>
    <message>
        <source>Run chmod 600 on it, and change the passwords if others use this machine.</source>
        <translation>Wenden Sie chmod 600 auf sie an, und ändern Sie die Passwörter, wenn andere diesen Rechner benutzen.</translation>
    </message>
    <message>
        <source>The file with the passwords of archives is damaged.</source>
        <translation>Die Datei mit den Passwörtern von Archiven ist beschädigt.</translation>
    </message>
    <message>
        <source>Remove it, and enter the passwords again.</source>
        <translation>Löschen Sie sie, und geben Sie die Passwörter noch einmal ein.</translation>
    </message>
    <message>
        <source>No archive has been set up.</source>
        <translation>Es ist kein Archiv eingerichtet.</translation>
    </message>
    <message>
        <source>Set one up with macula pacs add.</source>
        <translation>Richten Sie mit macula pacs add eines ein.</translation>
    </message>
    <message>
        <source>There is no archive of that name.</source>
        <translation>Es gibt kein Archiv mit diesem Namen.</translation>
    </message>
    <message>
        <source>These are there: {}.</source>
        <translation>Diese gibt es: {}.</translation>
    </message>
    <message>
        <source>The administrator has set up this archive; it cannot be changed here.</source>
        <translation>Die Systemverwaltung hat dieses Archiv eingerichtet; es kann hier nicht geändert werden.</translation>
    </message>
    <message>
        <source>Ask your administrator, or choose another name.</source>
        <translation>Fragen Sie Ihre Systemverwaltung, oder wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>The archive&apos;s answer cannot be read.</source>
        <translation>Die Antwort des Archivs kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check that the address is that of DICOMweb, and not of a page for people.</source>
        <translation>Prüfen Sie, ob die Adresse die von DICOMweb ist und nicht die einer Seite für Menschen.</translation>
    </message>
    <message>
        <source>read the archive&apos;s answer</source>
        <translation>die Antwort des Archivs zu lesen</translation>
    </message>
    <message>
        <source>The name of the archive&apos;s host is not known in the network.</source>
        <translation>Der Rechnername des Archivs ist im Netz nicht bekannt.</translation>
    </message>
    <message>
        <source>Check how the host is spelled in the address, and that this machine is in the right network.</source>
        <translation>Prüfen Sie, wie der Rechnername in der Adresse geschrieben ist, und ob dieser Rechner hier im richtigen Netz ist.</translation>
    </message>
    <message>
        <source>The name of the proxy is not known in the network.</source>
        <translation>Der Name des Proxys ist im Netz nicht bekannt.</translation>
    </message>
    <message>
        <source>Check the proxy in the settings of the archive, or in https_proxy.</source>
        <translation>Prüfen Sie den Proxy in den Einstellungen des Archivs oder in https_proxy.</translation>
    </message>
    <message>
        <source>The proxy does not connect to the archive.</source>
        <translation>Der Proxy verbindet nicht mit dem Archiv.</translation>
    </message>
    <message>
        <source>Ask whoever runs the proxy, or name the archive&apos;s host in no_proxy.</source>
        <translation>Fragen Sie die Verwaltung des Proxys, oder nennen Sie den Rechner des Archivs in no_proxy.</translation>
    </message>
    <message>
        <source>The archive&apos;s host does not accept connections at this port.</source>
        <translation>Der Rechner des Archivs nimmt an diesem Port keine Verbindungen an.</translation>
    </message>
    <message>
        <source>Check host and port in the address, and ask whether the service runs and the firewall lets it through.</source>
        <translation>Prüfen Sie Rechner und Port in der Adresse, und fragen Sie, ob der Dienst läuft und die Firewall ihn durchlässt.</translation>
    </message>
    <message>
        <source>The archive&apos;s host did not answer in time when it was called.</source>
        <translation>Der Rechner des Archivs hat auf den Verbindungsversuch nicht rechtzeitig geantwortet.</translation>
    </message>
    <message>
        <source>Check host and port in the address; a firewall may be in between.</source>
        <translation>Prüfen Sie Rechner und Port in der Adresse; vielleicht ist eine Firewall dazwischen.</translation>
    </message>
    <message>
        <source>The archive stopped answering.</source>
        <translation>Das Archiv hat aufgehört zu antworten.</translation>
    </message>
    <message>
        <source>Try again later, or set a longer time for answers.</source>
        <translation>Versuchen Sie es später noch einmal, oder stellen Sie eine längere Zeit für Antworten ein.</translation>
    </message>
    <message>
        <source>The archive closed the connection before its answer was complete.</source>
        <translation>Das Archiv hat die Verbindung geschlossen, bevor seine Antwort vollständig war.</translation>
    </message>
    <message>
        <source>Try again; if it happens again, ask the administrator of the archive.</source>
        <translation>Versuchen Sie es noch einmal; wenn es wieder vorkommt, fragen Sie die Verwaltung des Archivs.</translation>
    </message>
    <message>
        <source>What answers at this address does not speak as a web service does.</source>
        <translation>Was an dieser Adresse antwortet, spricht nicht wie ein Webdienst.</translation>
    </message>
    <message>
        <source>Check host and port in the address, and whether it begins with https://.</source>
        <translation>Prüfen Sie Rechner und Port in der Adresse, und ob sie mit https:// beginnt.</translation>
    </message>
    <message>
        <source>The archive refers to another host, which gets no requests.</source>
        <translation>Das Archiv verweist auf einen anderen Rechner, der keine Anfragen bekommt.</translation>
    </message>
    <message>
        <source>Enter the address that the archive&apos;s administrator names; a page for signing in may be in between.</source>
        <translation>Geben Sie die Adresse ein, die die Verwaltung des Archivs nennt; vielleicht liegt eine Seite zur Anmeldung dazwischen.</translation>
    </message>
    <message>
        <source>The archive&apos;s certificate is not valid at this time.</source>
        <translation>Das Zertifikat des Archivs ist zu dieser Zeit nicht gültig.</translation>
    </message>
    <message>
        <source>Check the clock of this machine; if it is right, the archive needs a new certificate.</source>
        <translation>Prüfen Sie die Uhr dieses Rechners; wenn sie richtig geht, braucht das Archiv ein neues Zertifikat.</translation>
    </message>
    <message>
        <source>The archive&apos;s certificate is signed by nobody whom this machine trusts.</source>
        <translation>Das Zertifikat des Archivs ist von niemandem signiert, dem dieser Rechner vertraut.</translation>
    </message>
    <message>
        <source>Name the file of the authority that signed it in the settings of the archive.</source>
        <translation>Geben Sie in den Einstellungen des Archivs die Datei der Zertifizierungsstelle an, die es signiert hat.</translation>
    </message>
    <message>
        <source>The archive&apos;s certificate is for another host.</source>
        <translation>Das Zertifikat des Archivs gilt für einen anderen Rechner.</translation>
    </message>
    <message>
        <source>Enter the host in the address as the certificate names it.</source>
        <translation>Geben Sie den Rechner in der Adresse so ein, wie ihn das Zertifikat nennt.</translation>
    </message>
    <message>
        <source>The archive&apos;s certificate was revoked.</source>
        <translation>Das Zertifikat des Archivs wurde widerrufen.</translation>
    </message>
    <message>
        <source>Do not use this archive until its administrator has renewed it.</source>
        <translation>Verwenden Sie dieses Archiv nicht, bis seine Verwaltung es erneuert hat.</translation>
    </message>
    <message>
        <source>The archive wants a certificate of this machine, and accepts none that it got.</source>
        <translation>Das Archiv verlangt ein Zertifikat dieses Rechners und akzeptiert keines, das es bekam.</translation>
    </message>
    <message>
        <source>Set certificate and key that the archive&apos;s administrator issued.</source>
        <translation>Stellen Sie Zertifikat und Schlüssel ein, die die Verwaltung des Archivs ausgestellt hat.</translation>
    </message>
    <message>
        <source>The certificate of this machine cannot be used with its key.</source>
        <translation>Das Zertifikat dieses Rechners kann mit seinem Schlüssel nicht verwendet werden.</translation>
    </message>
    <message>
        <source>Check both files, which must be PEM, and the passphrase of the key.</source>
        <translation>Prüfen Sie beide Dateien, die PEM sein müssen, und die Passphrase des Schlüssels.</translation>
    </message>
    <message>
        <source>The file or folder of trusted authorities cannot be read.</source>
        <translation>Die Datei oder der Ordner der vertrauenswürdigen Zertifizierungsstellen kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Check that it exists and holds certificates as PEM.</source>
        <translation>Prüfen Sie, ob es die Datei oder den Ordner gibt und ob darin Zertifikate als PEM sind.</translation>
    </message>
    <message>
        <source>The archive does not encrypt at this port.</source>
        <translation>Das Archiv verschlüsselt an diesem Port nicht.</translation>
    </message>
    <message>
        <source>Check the port in the address; without encryption it begins with http://.</source>
        <translation>Prüfen Sie den Port in der Adresse; ohne Verschlüsselung beginnt sie mit http://.</translation>
    </message>
    <message>
        <source>This computer and the archive could not agree on encryption.</source>
        <translation>Dieser Rechner und das Archiv konnten sich nicht auf eine Verschlüsselung einigen.</translation>
    </message>
    <message>
        <source>The archive must offer TLS 1.2 or later: ask its administrator.</source>
        <translation>Das Archiv muss TLS 1.2 oder neuer bieten: fragen Sie seine Verwaltung.</translation>
    </message>
    <message>
        <source>The archive&apos;s answer is larger than any should be.</source>
        <translation>Die Antwort des Archivs ist größer, als eine sein sollte.</translation>
    </message>
    <message>
        <source>The archive compresses its answers, although it was not asked to.</source>
        <translation>Das Archiv komprimiert seine Antworten, obwohl das nicht verlangt war.</translation>
    </message>
    <message>
        <source>Ask the administrator to send DICOMweb answers without compression.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, Antworten von DICOMweb ohne Kompression zu senden.</translation>
    </message>
    <message>
        <source>The archive does not understand the request (400).</source>
        <translation>Das Archiv versteht die Anfrage nicht (400).</translation>
    </message>
    <message>
        <source>Simplify the search, and check that the address is that of DICOMweb and begins with https:// where the archive encrypts.</source>
        <translation>Vereinfachen Sie die Suche, und prüfen Sie, ob die Adresse die von DICOMweb ist und mit https:// beginnt, wo das Archiv verschlüsselt.</translation>
    </message>
    <message>
        <source>The archive does not accept the sign-in (401).</source>
        <translation>Das Archiv akzeptiert die Anmeldung nicht (401).</translation>
    </message>
    <message>
        <source>Check user name and password, or the token, in the settings of the archive.</source>
        <translation>Prüfen Sie Benutzernamen und Passwort oder das Token in den Einstellungen des Archivs.</translation>
    </message>
    <message>
        <source>The archive does not allow this to the user that is signed in (403).</source>
        <translation>Das Archiv erlaubt das dem angemeldeten Benutzer nicht (403).</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive for the rights to search and retrieve.</source>
        <translation>Bitten Sie die Verwaltung des Archivs um die Rechte zum Suchen und Abrufen.</translation>
    </message>
    <message>
        <source>The archive has nothing at this address (404).</source>
        <translation>Das Archiv hat an dieser Adresse nichts (404).</translation>
    </message>
    <message>
        <source>Check the path in the address of the service; a study may have been removed.</source>
        <translation>Prüfen Sie den Pfad in der Adresse des Dienstes; vielleicht wurde auch eine Studie entfernt.</translation>
    </message>
    <message>
        <source>The archive does not offer this service ({}).</source>
        <translation>Das Archiv bietet diesen Dienst nicht ({}).</translation>
    </message>
    <message>
        <source>The archive cannot send images as they are stored (406).</source>
        <translation>Das Archiv kann Bilder nicht so senden, wie sie gespeichert sind (406).</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive whether WADO-RS is on, or use DIMSE with this archive.</source>
        <translation>Fragen Sie die Verwaltung des Archivs, ob WADO-RS eingeschaltet ist, oder verwenden Sie DIMSE mit diesem Archiv.</translation>
    </message>
    <message>
        <source>The archive could not store what it was sent (409).</source>
        <translation>Das Archiv konnte nicht speichern, was ihm gesendet wurde (409).</translation>
    </message>
    <message>
        <source>The archive, or a proxy before it, does not take files of this size (413).</source>
        <translation>Das Archiv oder ein Proxy davor nimmt Dateien dieser Größe nicht an (413).</translation>
    </message>
    <message>
        <source>Ask the administrator to raise the limit for uploads.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, die Grenze für das Hochladen zu erhöhen.</translation>
    </message>
    <message>
        <source>The archive does not take files of this kind (415).</source>
        <translation>Das Archiv nimmt Dateien dieser Art nicht an (415).</translation>
    </message>
    <message>
        <source>The archive has too much to do at the moment ({}).</source>
        <translation>Das Archiv hat zurzeit zu viel zu tun ({}).</translation>
    </message>
    <message>
        <source>Try again in some minutes.</source>
        <translation>Versuchen Sie es in einigen Minuten noch einmal.</translation>
    </message>
    <message>
        <source>The archive has a fault of its own ({}).</source>
        <translation>Das Archiv hat einen eigenen Fehler ({}).</translation>
    </message>
    <message>
        <source>Try again later; if it stays so, tell the administrator of the archive.</source>
        <translation>Versuchen Sie es später noch einmal; wenn es so bleibt, melden Sie es der Verwaltung des Archivs.</translation>
    </message>
    <message>
        <source>The archive answered with the unexpected status {}.</source>
        <translation>Das Archiv antwortete mit dem unerwarteten Status {}.</translation>
    </message>
    <message>
        <source>The connection with the archive failed, for a reason that the program did not foresee.</source>
        <translation>Die Verbindung mit dem Archiv misslang, aus einem Grund, den das Programm nicht vorhersah.</translation>
    </message>
    <message>
        <source>Try again; if it fails again, report it.</source>
        <translation>Versuchen Sie es noch einmal; wenn es wieder misslingt, melden Sie es.</translation>
    </message>
    <message>
        <source>The work with the archive was cancelled.</source>
        <translation>Die Arbeit mit dem Archiv wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The archive sent something else than the images that it was asked for.</source>
        <translation>Das Archiv hat etwas anderes gesendet als die Bilder, die verlangt wurden.</translation>
    </message>
    <message>
        <source>There is no space left for images from the archive.</source>
        <translation>Für Bilder aus dem Archiv ist kein Platz mehr.</translation>
    </message>
    <message>
        <source>The images from the archive cannot be written.</source>
        <translation>Die Bilder aus dem Archiv können nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Free space on the disk, or keep images elsewhere.</source>
        <translation>Schaffen Sie Platz auf dem Datenträger, oder bewahren Sie Bilder anderswo auf.</translation>
    </message>
    <message>
        <source>Check the folder in which images are kept, and its permissions.</source>
        <translation>Prüfen Sie den Ordner, in dem Bilder aufbewahrt werden, und seine Zugriffsrechte.</translation>
    </message>
    <message>
        <source>The archive&apos;s answer is not put together as DICOMweb wants it.</source>
        <translation>Die Antwort des Archivs ist nicht so aufgebaut, wie DICOMweb es verlangt.</translation>
    </message>
    <message>
        <source>The identifier of a study, series or image is malformed.</source>
        <translation>Die Kennung einer Studie, einer Serie oder eines Bildes ist fehlerhaft.</translation>
    </message>
    <message>
        <source>It has at most 64 digits and dots: choose from the archive&apos;s list instead.</source>
        <translation>Sie hat höchstens 64 Ziffern und Punkte: wählen Sie stattdessen aus der Liste des Archivs.</translation>
    </message>
    <message>
        <source>A date of the search is malformed.</source>
        <translation>Ein Datum der Suche ist fehlerhaft.</translation>
    </message>
    <message>
        <source>Write year, month and day with eight digits.</source>
        <translation>Schreiben Sie Jahr, Monat und Tag mit acht Ziffern.</translation>
    </message>
    <message>
        <source>The service that gives tokens for the archive did not give one.</source>
        <translation>Der Dienst, der Tokens für das Archiv ausgibt, hat keines ausgegeben.</translation>
    </message>
    <message>
        <source>Check its address, the client, its secret and the scope in the settings of the archive.</source>
        <translation>Prüfen Sie in den Einstellungen des Archivs seine Adresse, den Client, dessen Geheimnis und den Scope.</translation>
    </message>
    <message>
        <source>The service that gives tokens failed: {}</source>
        <translation>Der Dienst, der Tokens ausgibt, meldet einen Fehler: {}</translation>
    </message>
    <message>
        <source>The archive does not store objects of this kind.</source>
        <translation>Das Archiv speichert Objekte dieser Art nicht.</translation>
    </message>
    <message>
        <source>Ask its administrator to accept the kind, or send them elsewhere.</source>
        <translation>Bitten Sie seine Verwaltung, diese Art zu akzeptieren, oder senden Sie sie anderswohin.</translation>
    </message>
    <message>
        <source>The archive does not allow this user to store.</source>
        <translation>Das Archiv erlaubt diesem Benutzer das Speichern nicht.</translation>
    </message>
    <message>
        <source>Ask its administrator for the right to store.</source>
        <translation>Bitten Sie seine Verwaltung um das Recht zu speichern.</translation>
    </message>
    <message>
        <source>The archive has an object with this identifier already.</source>
        <translation>Das Archiv hat schon ein Objekt mit dieser Kennung.</translation>
    </message>
    <message>
        <source>Look there: if it is the same one, nothing is to be done.</source>
        <translation>Sehen Sie dort nach: wenn es dasselbe ist, ist nichts zu tun.</translation>
    </message>
    <message>
        <source>The archive does not store this encoding of the image.</source>
        <translation>Das Archiv speichert diese Kodierung des Bildes nicht.</translation>
    </message>
    <message>
        <source>Ask its administrator which encodings it takes.</source>
        <translation>Fragen Sie seine Verwaltung, welche Kodierungen es annimmt.</translation>
    </message>
    <message>
        <source>The object belongs to another study than the one it was sent to.</source>
        <translation>Das Objekt gehört zu einer anderen Studie als der, an die es gesendet wurde.</translation>
    </message>
    <message>
        <source>Send it again without the others.</source>
        <translation>Senden Sie es noch einmal, ohne die anderen.</translation>
    </message>
    <message>
        <source>The archive has no room left.</source>
        <translation>Das Archiv hat keinen Platz mehr.</translation>
    </message>
    <message>
        <source>Tell its administrator, and send again later.</source>
        <translation>Melden Sie es seiner Verwaltung, und senden Sie später noch einmal.</translation>
    </message>
    <message>
        <source>The archive finds that the object does not hold what its kind requires.</source>
        <translation>Das Archiv findet, dass das Objekt nicht enthält, was seine Art verlangt.</translation>
    </message>
    <message>
        <source>Ask whoever made the object; Macula sends it unchanged.</source>
        <translation>Fragen Sie dort nach, wo das Objekt erstellt wurde; Macula sendet es unverändert.</translation>
    </message>
    <message>
        <source>The archive does not understand the object.</source>
        <translation>Das Archiv versteht das Objekt nicht.</translation>
    </message>
    <message>
        <source>Check that the file opens here, and ask the administrator of the archive.</source>
        <translation>Prüfen Sie, ob die Datei sich hier öffnen lässt, und fragen Sie die Verwaltung des Archivs.</translation>
    </message>
    <message>
        <source>The archive failed while it stored the object.</source>
        <translation>Das Archiv ist gescheitert, als es das Objekt speicherte.</translation>
    </message>
    <message>
        <source>Send it again; if it fails again, ask the administrator of the archive.</source>
        <translation>Senden Sie es noch einmal; wenn es wieder misslingt, fragen Sie die Verwaltung des Archivs.</translation>
    </message>
    <message>
        <source>The archive did not store the object, and does not say why.</source>
        <translation>Das Archiv hat das Objekt nicht gespeichert und sagt nicht, warum.</translation>
    </message>
    <message>
        <source>The archive did not store the object, for its reason {:04X}.</source>
        <translation>Das Archiv hat das Objekt nicht gespeichert; sein Grund: {:04X}.</translation>
    </message>
    <message>
        <source>A file changed or went away while it was sent.</source>
        <translation>Eine Datei hat sich geändert oder ist verschwunden, während sie gesendet wurde.</translation>
    </message>
    <message>
        <source>Send it again when nobody else works with it.</source>
        <translation>Senden Sie sie noch einmal, wenn niemand sonst mit ihr arbeitet.</translation>
    </message>
    <message>
        <source>Enter the address of the DICOMweb service, such as https://pacs.example.org/dicom-web.</source>
        <translation>Geben Sie die Adresse des DICOMweb-Dienstes ein, etwa https://pacs.example.org/dicom-web.</translation>
    </message>
    <message>
        <source>The address of the archive holds a blank or a control character.</source>
        <translation>Die Adresse des Archivs enthält ein Leerzeichen oder ein Steuerzeichen.</translation>
    </message>
    <message>
        <source>The address of the archive is not one of the web.</source>
        <translation>Die Adresse des Archivs ist keine Webadresse.</translation>
    </message>
    <message>
        <source>The address of the archive begins with neither https:// nor http://.</source>
        <translation>Die Adresse des Archivs beginnt weder mit https:// noch mit http://.</translation>
    </message>
    <message>
        <source>The address of the archive holds a user name, which belongs in its own field.</source>
        <translation>Die Adresse des Archivs enthält einen Benutzernamen, der in sein eigenes Feld gehört.</translation>
    </message>
    <message>
        <source>The address of the archive has a question mark or a # in it.</source>
        <translation>Die Adresse des Archivs enthält ein Fragezeichen oder ein #.</translation>
    </message>
    <message>
        <source>The address of the archive names no host.</source>
        <translation>Die Adresse des Archivs nennt keinen Rechner.</translation>
    </message>
    <message>
        <source>work with the archive</source>
        <translation>mit dem Archiv zu arbeiten</translation>
    </message>
    <message>
        <source>The archive has no images of this study.</source>
        <translation>Das Archiv hat keine Bilder dieser Studie.</translation>
    </message>
    <message>
        <source>Search again: it may have been removed, or moved to another archive.</source>
        <translation>Suchen Sie noch einmal: vielleicht wurde sie entfernt oder in ein anderes Archiv verschoben.</translation>
    </message>
    <message>
        <source>Fetching {} images from the archive</source>
        <translation>{} Bilder werden aus dem Archiv abgerufen</translation>
    </message>
    <message>
        <source>The file or folder of trusted authorities does not exist.</source>
        <translation>Die Datei oder den Ordner der vertrauenswürdigen Zertifizierungsstellen gibt es nicht.</translation>
    </message>
    <message>
        <source>Name a PEM file, or leave the field empty for those of the system.</source>
        <translation>Geben Sie eine PEM-Datei an, oder lassen Sie das Feld für die des Systems leer.</translation>
    </message>
    <message>
        <source>The certificate of this machine, or its key, does not exist.</source>
        <translation>Das Zertifikat dieses Rechners oder seinen Schlüssel gibt es nicht.</translation>
    </message>
    <message>
        <source>Name the PEM files that the archive&apos;s administrator issued.</source>
        <translation>Geben Sie die PEM-Dateien an, die die Verwaltung des Archivs ausgestellt hat.</translation>
    </message>
    <message>
        <source>Name the PEM file of the certificate too.</source>
        <translation>Geben Sie auch die PEM-Datei des Zertifikats an.</translation>
    </message>
    <message>
        <source>A name, password or token of the sign-in holds a control character.</source>
        <translation>Ein Name, Passwort oder Token der Anmeldung enthält ein Steuerzeichen.</translation>
    </message>
    <message>
        <source>Enter it again, without a line end.</source>
        <translation>Geben Sie es noch einmal ein, ohne Zeilenende.</translation>
    </message>
    <message>
        <source>The user name of the sign-in holds a colon, which no user name may.</source>
        <translation>Der Benutzername der Anmeldung enthält einen Doppelpunkt, was kein Benutzername darf.</translation>
    </message>
    <message>
        <source>Enter the user name alone.</source>
        <translation>Geben Sie nur den Benutzernamen ein.</translation>
    </message>
    <message>
        <source>The sign-in has no user name.</source>
        <translation>Die Anmeldung hat keinen Benutzernamen.</translation>
    </message>
    <message>
        <source>Enter user name and password.</source>
        <translation>Geben Sie Benutzernamen und Passwort ein.</translation>
    </message>
    <message>
        <source>The sign-in has no token that could be sent.</source>
        <translation>Die Anmeldung hat kein Token, das gesendet werden könnte.</translation>
    </message>
    <message>
        <source>Enter the token that the archive&apos;s administrator issued.</source>
        <translation>Geben Sie das Token ein, das die Verwaltung des Archivs ausgestellt hat.</translation>
    </message>
    <message>
        <source>The address of the service that gives tokens does not begin with https://.</source>
        <translation>Die Adresse des Dienstes, der Tokens ausgibt, beginnt nicht mit https://.</translation>
    </message>
    <message>
        <source>Enter the address that the administrator of the sign-in names.</source>
        <translation>Geben Sie die Adresse ein, die die Verwaltung der Anmeldung nennt.</translation>
    </message>
    <message>
        <source>The sign-in has no name of the client.</source>
        <translation>Die Anmeldung hat keinen Namen des Clients.</translation>
    </message>
    <message>
        <source>Enter the client and its secret, as they are registered.</source>
        <translation>Geben Sie den Client und sein Geheimnis so ein, wie sie registriert sind.</translation>
    </message>
    <message>
        <source>A password or token would go over the network without encryption.</source>
        <translation>Ein Passwort oder Token ginge unverschlüsselt über das Netz.</translation>
    </message>
    <message>
        <source>Enter an address that begins with https://, or one of this machine, or no sign-in.</source>
        <translation>Geben Sie eine Adresse ein, die mit https:// beginnt, oder eine dieses Rechners, oder keine Anmeldung.</translation>
    </message>
    <message>
        <source>The address of the proxy is malformed.</source>
        <translation>Die Adresse des Proxys ist fehlerhaft.</translation>
    </message>
    <message>
        <source>Enter it as in http://proxy.example.org:3128, or leave it empty.</source>
        <translation>Geben Sie sie ein wie in http://proxy.example.org:3128, oder lassen Sie sie leer.</translation>
    </message>
    <message>
        <source>Sending {} images to the archive</source>
        <translation>{} Bilder werden an das Archiv gesendet</translation>
    </message>
    <message>
        <source>Ask whoever made the file: it has no valid SOP Instance UID.</source>
        <translation>Fragen Sie dort nach, wo die Datei erstellt wurde: sie hat keine gültige SOP Instance UID.</translation>
    </message>
    <message>
        <source>The first bytes are enough.</source>
        <translation>Die ersten Bytes genügen.</translation>
    </message>
    <message>
        <source>The archive finds images but does not send them.</source>
        <translation>Das Archiv findet Bilder, sendet sie aber nicht.</translation>
    </message>
    <message>
        <source>Ask its administrator whether WADO-RS is on.</source>
        <translation>Fragen Sie seine Verwaltung, ob WADO-RS eingeschaltet ist.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Encryption</source>
        <translation>Verschlüsselung</translation>
    </message>
    <message>
        <source>Sign-in</source>
        <translation>Anmeldung</translation>
    </message>
    <message>
        <source>Connected to {}.</source>
        <translation>Verbunden mit {}.</translation>
    </message>
    <message>
        <source>The certificate is valid.</source>
        <translation>Das Zertifikat ist gültig.</translation>
    </message>
    <message>
        <source>Testing the connection with the archive</source>
        <translation>Die Verbindung mit dem Archiv wird geprüft</translation>
    </message>
    <message>
        <source>The archive is empty, or shows nothing to this user.</source>
        <translation>Das Archiv ist leer oder zeigt diesem Benutzer nichts.</translation>
    </message>
    <message>
        <source>The archive answers searches.</source>
        <translation>Das Archiv antwortet auf die Suche.</translation>
    </message>
    <message>
        <source>There was no image to try it with.</source>
        <translation>Es gab kein Bild, um es damit zu prüfen.</translation>
    </message>
    <message>
        <source>The archive sends images.</source>
        <translation>Das Archiv sendet Bilder.</translation>
    </message>
    <message>
        <source>The archive has no such study.</source>
        <translation>Das Archiv hat keine solche Studie.</translation>
    </message>
    <message>
        <source>Search for it again: it may have been removed or merged.</source>
        <translation>Suchen Sie noch einmal nach ihr: vielleicht wurde sie entfernt oder mit einer anderen vereinigt.</translation>
    </message>
    <message>
        <source>{} of {} images that the archive has did not come.</source>
        <translation>Nicht gekommen: {} von {} Bildern, die das Archiv hat.</translation>
    </message>
    <message>
        <source>Fetch the study again, and tell the administrator of the archive if it stays so.</source>
        <translation>Rufen Sie die Studie noch einmal ab, und melden Sie es der Verwaltung des Archivs, wenn es so bleibt.</translation>
    </message>
    <message>
        <source>The archive sent {} images of another study or patient. They were not kept.</source>
        <translation>Bilder einer anderen Studie oder eines anderen Patienten, die das Archiv gesendet hat: {}. Sie wurden nicht behalten.</translation>
    </message>
    <message>
        <source>Tell the administrator of the archive.</source>
        <translation>Melden Sie es der Verwaltung des Archivs.</translation>
    </message>
    <message>
        <source>{} objects that came cannot be read. They were not kept.</source>
        <translation>Objekte, die gekommen sind und nicht gelesen werden können: {}. Sie wurden nicht behalten.</translation>
    </message>
    <message>
        <source>Nothing was sent.</source>
        <translation>Nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>One of the files is damaged or cut off; nothing was sent.</source>
        <translation>Eine der Dateien ist beschädigt oder abgeschnitten; nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>Leave it out.</source>
        <translation>Lassen Sie sie weg.</translation>
    </message>
    <message>
        <source>There is no DICOM file.</source>
        <translation>Dort gibt es keine DICOM-Datei.</translation>
    </message>
    <message>
        <source>The folder for fetched studies cannot be made.</source>
        <translation>Der Ordner für abgerufene Studien kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>Check the permissions of the folder above it.</source>
        <translation>Prüfen Sie die Zugriffsrechte des Ordners darüber.</translation>
    </message>
    <message>
        <source>A fetched study cannot be removed.</source>
        <translation>Eine abgerufene Studie kann nicht entfernt werden.</translation>
    </message>
    <message>
        <source>The notes on a fetched study are damaged.</source>
        <translation>Die Notizen zu einer abgerufenen Studie sind beschädigt.</translation>
    </message>
    <message>
        <source>Fetch the study again.</source>
        <translation>Rufen Sie die Studie noch einmal ab.</translation>
    </message>
    <message>
        <source>The folder for fetched studies cannot be written.</source>
        <translation>In den Ordner für abgerufene Studien kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Check its permissions and the free space.</source>
        <translation>Prüfen Sie seine Zugriffsrechte und den freien Platz.</translation>
    </message>
    <message>
        <source>Another program is fetching this study.</source>
        <translation>Ein anderes Programm ruft diese Studie gerade ab.</translation>
    </message>
    <message>
        <source>Wait until it is done.</source>
        <translation>Warten Sie, bis es fertig ist.</translation>
    </message>
    <message>
        <source>The images of this study that were fetched before name another patient than the archive does now.</source>
        <translation>Die Bilder dieser Studie, die früher abgerufen wurden, nennen einen anderen Patienten als das Archiv jetzt.</translation>
    </message>
    <message>
        <source>Tell the administrator of the archive. To fetch the study anew, remove what was fetched of it.</source>
        <translation>Melden Sie es der Verwaltung des Archivs. Um die Studie neu abzurufen, entfernen Sie, was von ihr abgerufen wurde.</translation>
    </message>
    <message>
        <source>The disk for fetched studies is full.</source>
        <translation>Der Datenträger für abgerufene Studien ist voll.</translation>
    </message>
    <message>
        <source>Free some space, or remove fetched studies with macula pacs purge. What came so far is kept.</source>
        <translation>Schaffen Sie Platz, oder entfernen Sie abgerufene Studien mit macula pacs purge. Was bisher gekommen ist, bleibt erhalten.</translation>
    </message>
    <message>
        <source>The archive sends more than {} images of one study.</source>
        <translation>Das Archiv sendet mehr als {} Bilder einer Studie.</translation>
    </message>
    <message>
        <source>Fetch single series of it.</source>
        <translation>Rufen Sie einzelne Serien davon ab.</translation>
    </message>
    <message>
        <source>Search an archive (PACS), and open a study from it</source>
        <translation>Archiv (PACS) durchsuchen und eine Studie daraus öffnen</translation>
    </message>
    <message>
        <source>Images of this study may be missing: the archive did not say which it has, or sent fewer.</source>
        <translation>Bilder dieser Studie können fehlen: Das Archiv hat nicht gesagt, welche es hat, oder weniger gesendet.</translation>
    </message>
    <message>
        <source>Fetching was cancelled.</source>
        <translation>Der Abruf wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The study is larger than all that is kept of fetched studies.</source>
        <translation>Die Studie ist größer als alles, was von abgerufenen Studien aufbewahrt wird.</translation>
    </message>
    <message>
        <source>{} of {} files were stored before this was cancelled.</source>
        <translation>{} von {} Dateien wurden gespeichert, bevor abgebrochen wurde.</translation>
    </message>
    <message>
        <source>The archive sends far more instances than it says it has.</source>
        <translation>Das Archiv sendet weit mehr Instanzen, als es zu haben angibt.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive what its log says about this study.</source>
        <translation>Fragen Sie die Verwaltung des Archivs, was sein Protokoll zu dieser Studie sagt.</translation>
    </message>
    <message>
        <source>The address of the proxy holds a user name or password, which others could read there.</source>
        <translation>Die Adresse des Proxys enthält einen Benutzernamen oder ein Passwort, die andere dort lesen könnten.</translation>
    </message>
    <message>
        <source>Leave it out, and ask whoever runs the proxy to allow this machine without one.</source>
        <translation>Lassen Sie das weg, und bitten Sie die Verwaltung des Proxys, diesen Rechner ohne Anmeldung zuzulassen.</translation>
    </message>
    <message>
        <source>The archive has no room for this instance, or cannot use it (status {}).</source>
        <translation>Das Archiv hat keinen Platz für diese Instanz oder kann mit ihr nichts anfangen (Status {}).</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive what its log says, then send again.</source>
        <translation>Fragen Sie die Verwaltung des Archivs, was dessen Protokoll sagt, und senden Sie dann noch einmal.</translation>
    </message>
    <message>
        <source>The service that signs people in gave no code.</source>
        <translation>Der Anmeldedienst hat keinen Code ausgestellt.</translation>
    </message>
    <message>
        <source>Check its address, the client and the scope in the settings of the archive.</source>
        <translation>Prüfen Sie seine Adresse, den Client und den Scope in den Einstellungen des Archivs.</translation>
    </message>
    <message>
        <source>The service that signs people in failed: {}</source>
        <translation>Der Anmeldedienst ist gescheitert: {}</translation>
    </message>
    <message>
        <source>The sign-in was declined in the browser.</source>
        <translation>Die Anmeldung wurde im Browser abgelehnt.</translation>
    </message>
    <message>
        <source>Begin again, and agree there.</source>
        <translation>Beginnen Sie noch einmal und stimmen Sie dort zu.</translation>
    </message>
    <message>
        <source>Nobody signed in before the code ran out.</source>
        <translation>Niemand hat sich angemeldet, bevor der Code abgelaufen ist.</translation>
    </message>
    <message>
        <source>Begin again, and type the new code in the browser.</source>
        <translation>Beginnen Sie noch einmal und geben Sie den neuen Code im Browser ein.</translation>
    </message>
    <message>
        <source>Nobody signs in at this archive by a browser.</source>
        <translation>Bei diesem Archiv meldet man sich nicht mit einem Browser an.</translation>
    </message>
    <message>
        <source>Set it up so, or enter a password for it.</source>
        <translation>Richten Sie es so ein, oder geben Sie ein Passwort dafür ein.</translation>
    </message>
    <message>
        <source>Waiting for the sign-in in a browser</source>
        <translation>Warten auf die Anmeldung in einem Browser</translation>
    </message>
    <message>
        <source>The sign-in at the archive is over.</source>
        <translation>Die Anmeldung beim Archiv ist abgelaufen.</translation>
    </message>
    <message>
        <source>Sign in again: in the settings of the archive, or by macula pacs sign-in.</source>
        <translation>Melden Sie sich noch einmal an: in den Einstellungen des Archivs oder mit macula pacs sign-in.</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>A private folder cannot be made.</source>
        <translation>Ein privater Ordner kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>Check free space, and the permissions of the folder above it.</source>
        <translation>Prüfen Sie freien Platz und die Zugriffsrechte des übergeordneten Ordners.</translation>
    </message>
    <message>
        <source>Get the manifest again from where it was made.</source>
        <translation>Holen Sie das Manifest noch einmal von dort, wo es erstellt wurde.</translation>
    </message>
    <message>
        <source>The manifest names more than {} studies.</source>
        <translation>Das Manifest nennt mehr als {} Studien.</translation>
    </message>
    <message>
        <source>The manifest names more than {} series.</source>
        <translation>Das Manifest nennt mehr als {} Serien.</translation>
    </message>
    <message>
        <source>The manifest names more than {} images.</source>
        <translation>Das Manifest nennt mehr als {} Bilder.</translation>
    </message>
    <message>
        <source>Imaging manifest</source>
        <translation>Bildmanifest</translation>
    </message>
    <message>
        <source>The file is no imaging manifest.</source>
        <translation>Die Datei ist kein Bildmanifest.</translation>
    </message>
    <message>
        <source>Choose a DICOM Key Object Selection whose title is Manifest, as IHE MADO defines it.</source>
        <translation>Wählen Sie eine DICOM Key Object Selection mit dem Titel Manifest, wie IHE MADO sie definiert.</translation>
    </message>
    <message>
        <source>The manifest names no images.</source>
        <translation>Das Manifest nennt keine Bilder.</translation>
    </message>
    <message>
        <source>There is not enough memory for the manifest.</source>
        <translation>Für das Manifest ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>By DICOMweb, an archive cannot be asked to confirm that it keeps what was stored.</source>
        <translation>Über DICOMweb lässt sich von einem Archiv keine Bestätigung verlangen, dass es aufbewahrt, was gespeichert wurde.</translation>
    </message>
    <message>
        <source>Set the archive up by DIMSE too, or search it for what was stored.</source>
        <translation>Richten Sie das Archiv auch über DIMSE ein, oder suchen Sie darin, was gespeichert wurde.</translation>
    </message>
    <message>
        <source>Another program already listens at port {}.</source>
        <translation>Ein anderes Programm lauscht schon am Port {}.</translation>
    </message>
    <message>
        <source>End that program, or choose another port here and where the images come from.</source>
        <translation>Beenden Sie das andere Programm, oder wählen Sie einen anderen Port, hier und dort, woher die Bilder kommen.</translation>
    </message>
    <message>
        <source>This program may not listen at port {}.</source>
        <translation>Dieses Programm darf am Port {} nicht lauschen.</translation>
    </message>
    <message>
        <source>Choose a port above 1023, here and where the images come from.</source>
        <translation>Wählen Sie einen Port über 1023, hier und dort, woher die Bilder kommen.</translation>
    </message>
    <message>
        <source>This machine has no such address to listen at.</source>
        <translation>Dieser Rechner hat keine solche Adresse, an der er lauschen könnte.</translation>
    </message>
    <message>
        <source>Leave the address out, or enter one of this machine.</source>
        <translation>Lassen Sie die Adresse weg, oder geben Sie eine dieses Rechners ein.</translation>
    </message>
    <message>
        <source>{} is no address.</source>
        <translation>{} ist keine Adresse.</translation>
    </message>
    <message>
        <source>Enter an IP address or a range of them, such as 10.1.0.0/16. Host names are not enough: somebody else could answer for them.</source>
        <translation>Geben Sie eine IP-Adresse oder einen Adressbereich ein, etwa 10.1.0.0/16. Rechnernamen genügen nicht: ein anderer Rechner könnte sich dafür ausgeben.</translation>
    </message>
    <message>
        <source>The archive has not said yet whether it keeps this object.</source>
        <translation>Das Archiv hat noch nicht gesagt, ob es dieses Objekt aufbewahrt.</translation>
    </message>
    <message>
        <source>Ask again later. The archive must know the receiver&apos;s AE title, host name and port, and no firewall may block them.</source>
        <translation>Fragen Sie später noch einmal. Das Archiv muss AE-Titel, Rechnernamen und Port des Empfängers kennen, und keine Firewall darf sie sperren.</translation>
    </message>
    <message>
        <source>Most archives report over a connection of their own: enter a receiver&apos;s port in the settings of the archive, and have AE title, host name and port entered there.</source>
        <translation>Die meisten Archive melden sich über eine eigene Verbindung: geben Sie in den Einstellungen des Archivs den Port eines Empfängers ein, und lassen Sie dessen AE-Titel, Rechnernamen und Port im Archiv eintragen.</translation>
    </message>
    <message>
        <source>Waiting for the archive to confirm that it keeps the files</source>
        <translation>Warten auf die Bestätigung des Archivs, dass es die Dateien aufbewahrt</translation>
    </message>
    <message>
        <source>The archive does not have this object (reason {}).</source>
        <translation>Das Archiv hat dieses Objekt nicht (Grund {}).</translation>
    </message>
    <message>
        <source>Send it again.</source>
        <translation>Senden Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The archive has this object as one of another kind (reason {}).</source>
        <translation>Das Archiv führt dieses Objekt als eines anderer Art (Grund {}).</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive what it has under this identity.</source>
        <translation>Fragen Sie die Verwaltung des Archivs, was es unter dieser Kennung hat.</translation>
    </message>
    <message>
        <source>The archive does not promise to keep objects of this kind (reason {}).</source>
        <translation>Das Archiv sagt nicht zu, Objekte dieser Art aufzubewahren (Grund {}).</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive where such objects are kept.</source>
        <translation>Fragen Sie die Verwaltung des Archivs, wo solche Objekte aufbewahrt werden.</translation>
    </message>
    <message>
        <source>The archive took the request for one that it had before (reason {}).</source>
        <translation>Das Archiv hat die Anfrage für eine frühere gehalten (Grund {}).</translation>
    </message>
    <message>
        <source>Ask it again.</source>
        <translation>Fragen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The archive has no room to keep this object (reason {}).</source>
        <translation>Das Archiv hat keinen Platz, um dieses Objekt aufzubewahren (Grund {}).</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive to make room, then send again.</source>
        <translation>Bitten Sie die Verwaltung des Archivs, Platz zu schaffen, und senden Sie dann noch einmal.</translation>
    </message>
    <message>
        <source>The archive does not promise to keep this object (reason {}).</source>
        <translation>Das Archiv sagt nicht zu, dieses Objekt aufzubewahren (Grund {}).</translation>
    </message>
    <message>
        <source>The archive does not confirm what it keeps: it does not offer storage commitment.</source>
        <translation>Das Archiv bestätigt nicht, was es aufbewahrt: es bietet kein Storage Commitment.</translation>
    </message>
    <message>
        <source>Ask the administrator of the archive whether it offers it to this AE title, or search the archive for what was stored.</source>
        <translation>Fragen Sie die Verwaltung des Archivs, ob es das diesem AE-Titel bietet, oder suchen Sie im Archiv, was gespeichert wurde.</translation>
    </message>
    <message>
        <source>Other machines could send to this program, and nobody said which may.</source>
        <translation>Andere Rechner könnten an dieses Programm senden, und es wurde nicht angegeben, welche das dürfen.</translation>
    </message>
    <message>
        <source>Name those that may send, or say that anyone may.</source>
        <translation>Geben Sie die an, die senden dürfen, oder dass alle es dürfen.</translation>
    </message>
    <message>
        <source>To protect connections that others make, this program needs a certificate.</source>
        <translation>Um Verbindungen zu schützen, die andere aufbauen, braucht dieses Programm ein Zertifikat.</translation>
    </message>
    <message>
        <source>Enter a certificate with its key.</source>
        <translation>Geben Sie ein Zertifikat mit seinem Schlüssel an.</translation>
    </message>
    <message>
        <source>{} wanted to send, and is not among those that may.</source>
        <translation>{} wollte senden und gehört nicht zu denen, die das dürfen.</translation>
    </message>
    <message>
        <source>{} called this program by another AE title.</source>
        <translation>{} hat dieses Programm mit einem anderen AE-Titel angesprochen.</translation>
    </message>
    <message>
        <source>{} was turned away, because as many connections are open as this program allows.</source>
        <translation>{} wurde abgewiesen, weil schon so viele Verbindungen offen sind, wie dieses Programm erlaubt.</translation>
    </message>
    <message>
        <source>{} was turned away, because more connections came than this program allows.</source>
        <translation>{} wurde abgewiesen, weil mehr Verbindungen kamen, als dieses Programm erlaubt.</translation>
    </message>
    <message>
        <source>{} made no protected connection, or showed no certificate that is trusted.</source>
        <translation>{} hat keine geschützte Verbindung aufgebaut oder kein Zertifikat gezeigt, dem vertraut wird.</translation>
    </message>
    <message>
        <source>{} did not ask to send images as DICOM prescribes.</source>
        <translation>{} hat das Senden von Bildern nicht so angefragt, wie DICOM es vorschreibt.</translation>
    </message>
    <message>
        <source>The archive names another patient for this study than the list or the manifest that it was chosen from.</source>
        <translation>Das Archiv nennt für diese Studie einen anderen Patienten als die Liste oder das Manifest, woraus sie gewählt wurde.</translation>
    </message>
    <message>
        <source>Do not rely on either. Search again, and tell the administrator of the archive.</source>
        <translation>Verlassen Sie sich auf keine der beiden Angaben. Suchen Sie noch einmal, und melden Sie es der Verwaltung des Archivs.</translation>
    </message>
    <message>
        <source>{} objects came that name another patient than the rest of this study. They were not kept.</source>
        <translation>Objekte, die gekommen sind und einen anderen Patienten nennen als der Rest dieser Studie: {}. Sie wurden nicht behalten.</translation>
    </message>
    <message>
        <source>Tell the administrator of the machine that sent them.</source>
        <translation>Melden Sie es der Verwaltung des Rechners, der sie gesendet hat.</translation>
    </message>
    <message>
        <source>The link has a percent sign without two digits behind it.</source>
        <translation>Der Link hat ein Prozentzeichen, auf das keine zwei Ziffern folgen.</translation>
    </message>
    <message>
        <source>The link holds letters that are not UTF-8.</source>
        <translation>Der Link enthält Zeichen, die kein UTF-8 sind.</translation>
    </message>
    <message>
        <source>The link holds control characters.</source>
        <translation>Der Link enthält Steuerzeichen.</translation>
    </message>
    <message>
        <source>The link has a part that is not written as key=value.</source>
        <translation>Der Link hat einen Teil, der nicht als Schlüssel=Wert geschrieben ist.</translation>
    </message>
    <message>
        <source>The link gives one of its keys twice.</source>
        <translation>Der Link nennt einen seiner Schlüssel zweimal.</translation>
    </message>
    <message>
        <source>The link has too many parts.</source>
        <translation>Der Link hat zu viele Teile.</translation>
    </message>
    <message>
        <source>The link holds a user name or a password.</source>
        <translation>Der Link enthält einen Benutzernamen oder ein Passwort.</translation>
    </message>
    <message>
        <source>This is no link of Macula.</source>
        <translation>Das ist kein Link von Macula.</translation>
    </message>
    <message>
        <source>The link has no // behind its beginning.</source>
        <translation>Dem Link fehlt // hinter seinem Anfang.</translation>
    </message>
    <message>
        <source>The link asks for something that Macula does not do.</source>
        <translation>Der Link verlangt etwas, das Macula nicht tut.</translation>
    </message>
    <message>
        <source>Nothing was opened. Links are written as macula://open?study=UID, with accession=NUMBER or patient=ID instead of study, and may end in &amp;archive=NAME; or as macula://IHEInvokeImageDisplay?requestType=STUDY&amp;studyUID=UID.</source>
        <translation>Es wurde nichts geöffnet. Links werden als macula://open?study=UID geschrieben, auch mit accession=NUMMER oder patient=ID statt study, und können mit &amp;archive=NAME enden; oder als macula://IHEInvokeImageDisplay?requestType=STUDY&amp;studyUID=UID.</translation>
    </message>
    <message>
        <source>The link is too long.</source>
        <translation>Der Link ist zu lang.</translation>
    </message>
    <message>
        <source>The link holds a blank or a control character.</source>
        <translation>Der Link enthält ein Leerzeichen oder ein Steuerzeichen.</translation>
    </message>
    <message>
        <source>The link has a # in it; within a value it is written as %23.</source>
        <translation>Der Link enthält ein #; innerhalb eines Werts wird es als %23 geschrieben.</translation>
    </message>
    <message>
        <source>The link does not say which study it means.</source>
        <translation>Der Link sagt nicht, welche Studie er meint.</translation>
    </message>
    <message>
        <source>Asking the archive for the study</source>
        <translation>Das Archiv wird nach der Studie gefragt</translation>
    </message>
    <message>
        <source>Asking {} archives for the study</source>
        <translation>{} Archive werden nach der Studie gefragt</translation>
    </message>
    <message>
        <source>{} could not be asked: {}</source>
        <translation>{} konnte nicht gefragt werden: {}</translation>
    </message>
    <message>
        <source>{} has more studies that match.</source>
        <translation>{} hat weitere Studien, die passen.</translation>
    </message>
    <message>
        <source>{} also answered {} studies that the link does not ask for.</source>
        <translation>{} hat auch Studien genannt, nach denen der Link nicht fragt: {}.</translation>
    </message>
    <message>
        <source>{} has no study that fits the link.</source>
        <translation>{} hat keine Studie, die zum Link passt.</translation>
    </message>
    <message>
        <source>None of {} archives has a study that fits the link.</source>
        <translation>Keines von {} Archiven hat eine Studie, die zum Link passt.</translation>
    </message>
    <message>
        <source>Search for the study in the panel Archive or with macula find, or ask whoever made the link.</source>
        <translation>Suchen Sie die Studie im Bereich Archiv oder mit macula find, oder fragen Sie dort nach, wo der Link erstellt wurde.</translation>
    </message>
    <message>
        <source>The search was cancelled.</source>
        <translation>Die Suche wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Part {} of the link is something that Macula does not know.</source>
        <translation>Teil {} des Links ist etwas, das Macula nicht kennt.</translation>
    </message>
    <message>
        <source>Nothing was opened. Such links may have {}.</source>
        <translation>Es wurde nichts geöffnet. Solche Links dürfen dies enthalten: {}.</translation>
    </message>
    <message>
        <source>The link holds a number or an ID that is longer than any real one.</source>
        <translation>Der Link enthält eine Nummer oder eine ID, die länger ist als jede echte.</translation>
    </message>
    <message>
        <source>The link holds a wildcard, which would find other studies too.</source>
        <translation>Der Link enthält einen Platzhalter, der auch andere Studien fände.</translation>
    </message>
    <message>
        <source>The link names too many studies.</source>
        <translation>Der Link nennt zu viele Studien.</translation>
    </message>
    <message>
        <source>The link names a study by something that is no UID.</source>
        <translation>Der Link nennt eine Studie mit etwas, das keine UID ist.</translation>
    </message>
    <message>
        <source>The link holds a day that is not written as 2026-11-30.</source>
        <translation>Der Link enthält einen Tag, der nicht wie 2026-11-30 geschrieben ist.</translation>
    </message>
    <message>
        <source>The link has a choice that is neither true nor false.</source>
        <translation>Der Link hat eine Ja/Nein-Angabe, die weder true noch false ist.</translation>
    </message>
    <message>
        <source>The link says who issued the patient&apos;s ID; Macula searches by the ID alone, and other hospitals may have given the same one.</source>
        <translation>Der Link sagt, wer die Patienten-ID vergeben hat; Macula sucht nur nach der ID, und andere Krankenhäuser können dieselbe vergeben haben.</translation>
    </message>
    <message>
        <source>study, accession, patient, issuer and archive</source>
        <translation>study, accession, patient, issuer und archive</translation>
    </message>
    <message>
        <source>The link names more than one of study, accession number and patient.</source>
        <translation>Der Link nennt mehr als eines von Studie, Accession-Nummer und Patient.</translation>
    </message>
    <message>
        <source>The link says who issued a patient&apos;s ID, and names no patient.</source>
        <translation>Der Link sagt, wer eine Patienten-ID vergeben hat, und nennt keinen Patienten.</translation>
    </message>
    <message>
        <source>The link asks for a viewer of a certain kind; Macula has only its own window.</source>
        <translation>Der Link verlangt einen Viewer einer bestimmten Art; Macula hat nur sein eigenes Fenster.</translation>
    </message>
    <message>
        <source>The link asks for a display of diagnostic quality; Macula is not for primary diagnosis.</source>
        <translation>Der Link verlangt eine Darstellung in diagnostischer Qualität; Macula ist nicht zur Primärdiagnose.</translation>
    </message>
    <message>
        <source>The link asks for key images only; Macula opens the whole study.</source>
        <translation>Der Link verlangt nur Schlüsselbilder (Key Images); Macula öffnet die ganze Studie.</translation>
    </message>
    <message>
        <source>The link has additional parameters, which Macula does not know.</source>
        <translation>Der Link hat zusätzliche Parameter, die Macula nicht kennt.</translation>
    </message>
    <message>
        <source>The link says who issued the accession number; Macula searches by the number alone.</source>
        <translation>Der Link sagt, wer die Accession-Nummer vergeben hat; Macula sucht nur nach der Nummer.</translation>
    </message>
    <message>
        <source>requestType, studyUID, accessionNumber, viewerType, diagnosticQuality, keyImagesOnly and additionalParameters</source>
        <translation>requestType, studyUID, accessionNumber, viewerType, diagnosticQuality, keyImagesOnly und additionalParameters</translation>
    </message>
    <message>
        <source>The link names the patient; Macula searches by the ID alone, so check the name yourself.</source>
        <translation>Der Link nennt den Patienten; Macula sucht nur nach der ID, prüfen Sie den Namen also selbst.</translation>
    </message>
    <message>
        <source>The link gives times of the day; Macula takes the studies of the whole days.</source>
        <translation>Der Link gibt Uhrzeiten an; Macula nimmt die Studien der ganzen Tage.</translation>
    </message>
    <message>
        <source>The link names a modality that is none.</source>
        <translation>Der Link nennt als Modalität etwas, das keine ist.</translation>
    </message>
    <message>
        <source>The link asks for a number of recent studies that is none.</source>
        <translation>Die Anzahl der letzten Studien, die der Link verlangt, ist keine gültige Zahl.</translation>
    </message>
    <message>
        <source>requestType, patientID, patientName, patientBirthDate, lowerDateTime, upperDateTime, mostRecentResults, modalitiesInStudy, viewerType, diagnosticQuality, keyImagesOnly and additionalParameters</source>
        <translation>requestType, patientID, patientName, patientBirthDate, lowerDateTime, upperDateTime, mostRecentResults, modalitiesInStudy, viewerType, diagnosticQuality, keyImagesOnly und additionalParameters</translation>
    </message>
    <message>
        <source>The link does not say which patient it means.</source>
        <translation>Der Link sagt nicht, welchen Patienten er meint.</translation>
    </message>
    <message>
        <source>The link&apos;s first day is after its last one.</source>
        <translation>Der erste Tag des Links liegt nach dem letzten.</translation>
    </message>
    <message>
        <source>The link&apos;s requestType is neither STUDY nor PATIENT.</source>
        <translation>Der requestType des Links ist weder STUDY noch PATIENT.</translation>
    </message>
    <message>
        <source>This is an imaging manifest: it names images that lie in an archive. Open its file to fetch them.</source>
        <translation>Das ist ein Bildmanifest: es nennt Bilder, die in einem Archiv liegen. Öffnen Sie seine Datei, um sie abzurufen.</translation>
    </message>
    <message>
        <source>{} of {} images that the manifest names did not come.</source>
        <translation>Nicht gekommen: {} von {} Bildern, die das Manifest nennt.</translation>
    </message>
    <message>
        <source>Fetch the study again, or ask whoever made the manifest: images may have been removed, or lie elsewhere.</source>
        <translation>Rufen Sie die Studie noch einmal ab, oder fragen Sie dort nach, wo das Manifest erstellt wurde: vielleicht wurden Bilder entfernt oder liegen anderswo.</translation>
    </message>
    <message>
        <source>Or say which archive has the study: macula fetch ARCHIVE --manifest FILE.</source>
        <translation>Oder geben Sie an, welches Archiv die Studie hat: macula fetch ARCHIV --manifest DATEI.</translation>
    </message>
    <message>
        <source>Say which archive has the study: macula fetch ARCHIVE --manifest FILE.</source>
        <translation>Geben Sie an, welches Archiv die Studie hat: macula fetch ARCHIV --manifest DATEI.</translation>
    </message>
    <message>
        <source>The manifest says that the series of a study lie in different archives.</source>
        <translation>Das Manifest sagt, dass die Serien einer Studie in verschiedenen Archiven liegen.</translation>
    </message>
    <message>
        <source>The manifest says that images lie at an address of which no archive is set up.</source>
        <translation>Das Manifest sagt, dass Bilder an einer Adresse liegen, zu der kein Archiv eingerichtet ist.</translation>
    </message>
    <message>
        <source>If you trust this address, set it up as an archive, and open the manifest again.</source>
        <translation>Wenn Sie dieser Adresse vertrauen, richten Sie sie als Archiv ein, und öffnen Sie das Manifest noch einmal.</translation>
    </message>
    <message>
        <source>The manifest says that images lie in an archive whose AE title is not set up.</source>
        <translation>Das Manifest sagt, dass Bilder in einem Archiv liegen, dessen AE-Titel nicht eingerichtet ist.</translation>
    </message>
    <message>
        <source>Set up the archive of this AE title, and open the manifest again.</source>
        <translation>Richten Sie das Archiv mit diesem AE-Titel ein, und öffnen Sie das Manifest noch einmal.</translation>
    </message>
    <message>
        <source>The manifest does not say where its images lie.</source>
        <translation>Das Manifest sagt nicht, wo seine Bilder liegen.</translation>
    </message>
    <message>
        <source>There is no such entry in the queue.</source>
        <translation>Einen solchen Eintrag gibt es in der Warteschlange nicht.</translation>
    </message>
    <message>
        <source>It may have been sent or removed. macula pacs queue lists what waits.</source>
        <translation>Er wurde vielleicht gesendet oder entfernt. macula pacs queue listet auf, was wartet.</translation>
    </message>
    <message>
        <source>The objects could not be copied into the queue.</source>
        <translation>Die Objekte konnten nicht in die Warteschlange kopiert werden.</translation>
    </message>
    <message>
        <source>Check the permissions of this folder and the free space.</source>
        <translation>Prüfen Sie die Zugriffsrechte dieses Ordners und den freien Platz.</translation>
    </message>
    <message>
        <source>One of the files is no whole DICOM object; nothing was put into the queue.</source>
        <translation>Eine der Dateien ist kein vollständiges DICOM-Objekt; nichts kam in die Warteschlange.</translation>
    </message>
    <message>
        <source>Leave it out, or write it again.</source>
        <translation>Lassen Sie sie weg, oder speichern Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>One of the files is of a patient or study that was not confirmed; nothing was put into the queue.</source>
        <translation>Eine der Dateien ist von einem nicht bestätigten Patienten oder einer nicht bestätigten Studie; nichts kam in die Warteschlange.</translation>
    </message>
    <message>
        <source>Send it again, and check the names in the question.</source>
        <translation>Senden Sie sie noch einmal, und prüfen Sie die Namen in der Frage.</translation>
    </message>
    <message>
        <source>Copying {} objects into the queue</source>
        <translation>{} Objekte werden in die Warteschlange kopiert</translation>
    </message>
    <message>
        <source>Nothing was put into the queue.</source>
        <translation>Nichts kam in die Warteschlange.</translation>
    </message>
    <message>
        <source>An entry of the queue is named by at least {} hexadecimal digits.</source>
        <translation>Ein Eintrag der Warteschlange wird durch mindestens {} hexadezimale Ziffern benannt.</translation>
    </message>
    <message>
        <source>macula pacs queue lists them.</source>
        <translation>macula pacs queue listet sie auf.</translation>
    </message>
    <message>
        <source>Several entries of the queue begin with these digits.</source>
        <translation>Mehrere Einträge der Warteschlange beginnen mit diesen Ziffern.</translation>
    </message>
    <message>
        <source>Give more of them.</source>
        <translation>Geben Sie mehr davon an.</translation>
    </message>
    <message>
        <source>These objects are being sent at this moment.</source>
        <translation>Diese Objekte werden gerade gesendet.</translation>
    </message>
    <message>
        <source>Wait until that is done.</source>
        <translation>Warten Sie, bis das fertig ist.</translation>
    </message>
    <message>
        <source>One of the files is gone; nothing was put into the queue.</source>
        <translation>Eine der Dateien gibt es nicht mehr; nichts kam in die Warteschlange.</translation>
    </message>
    <message>
        <source>The disk is too full to keep objects in the queue.</source>
        <translation>Der Datenträger ist zu voll, um Objekte in der Warteschlange aufzubewahren.</translation>
    </message>
    <message>
        <source>Free some space, then send them again.</source>
        <translation>Schaffen Sie Platz, und senden Sie sie dann noch einmal.</translation>
    </message>
    <message>
        <source>The notes on objects that wait for an archive are damaged.</source>
        <translation>Die Notizen zu Objekten, die auf ein Archiv warten, sind beschädigt.</translation>
    </message>
    <message>
        <source>The objects lie in this folder. Send them again, then remove the entry.</source>
        <translation>Die Objekte liegen in diesem Ordner. Senden Sie sie noch einmal, und entfernen Sie dann den Eintrag.</translation>
    </message>
    <message>
        <source>Sending was cancelled.</source>
        <translation>Das Senden wurde abgebrochen.</translation>
    </message>
    <message>
        <source>What was made names another patient than the question did; nothing was sent.</source>
        <translation>Was erstellt wurde, nennt einen anderen Patienten als die Frage; nichts wurde gesendet.</translation>
    </message>
    <message>
        <source>The files of this study may have changed on the disk. Open it again.</source>
        <translation>Die Dateien dieser Studie haben sich vielleicht auf dem Datenträger geändert. Öffnen Sie die Studie noch einmal.</translation>
    </message>
    <message>
        <source>make the objects to send</source>
        <translation>die Objekte zu erstellen, die gesendet werden sollen</translation>
    </message>
    <message>
        <source>There are no measurements to write.</source>
        <translation>Es gibt keine Messungen zu speichern.</translation>
    </message>
    <message>
        <source>Measure something on a slice first.</source>
        <translation>Messen Sie zuerst etwas auf einer Schicht.</translation>
    </message>
    <message>
        <source>A report of measurements refers to DICOM images with identifiers, and this volume has none.</source>
        <translation>Ein Messbericht bezieht sich auf DICOM-Bilder mit Kennungen, und dieses Volumen hat keine.</translation>
    </message>
    <message>
        <source>Save the measurements as a table.</source>
        <translation>Speichern Sie die Messungen als Tabelle.</translation>
    </message>
    <message>
        <source>A measurement has a point or a number that a report cannot hold.</source>
        <translation>Eine Messung hat einen Punkt oder eine Zahl, die ein Messbericht nicht fassen kann.</translation>
    </message>
    <message>
        <source>Remove the measurement, or save the measurements as a table.</source>
        <translation>Entfernen Sie die Messung, oder speichern Sie die Messungen als Tabelle.</translation>
    </message>
    <message>
        <source>Write the measurements without patient and study.</source>
        <translation>Speichern Sie die Messungen ohne Patient und Studie.</translation>
    </message>
    <message>
        <source>A segmentation cannot be written for a volume of that kind.</source>
        <translation>Für ein Volumen dieser Art kann keine Segmentierung gespeichert werden.</translation>
    </message>
    <message>
        <source>A segment lies outside of the volume.</source>
        <translation>Ein Segment liegt außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>No voxel of this volume belongs to a segment.</source>
        <translation>Kein Voxel dieses Volumens gehört zu einem Segment.</translation>
    </message>
    <message>
        <source>A segmentation refers to DICOM images with identifiers and a frame of reference, and this series has none.</source>
        <translation>Eine Segmentierung bezieht sich auf DICOM-Bilder mit Kennungen und einem Koordinatensystem, und diese Serie hat keine.</translation>
    </message>
    <message>
        <source>Write the segmentation without patient and study.</source>
        <translation>Speichern Sie die Segmentierung ohne Patient und Studie.</translation>
    </message>
    <message>
        <source>These segments need more frames than one DICOM file can hold.</source>
        <translation>Diese Segmente brauchen mehr Einzelbilder, als eine DICOM-Datei fassen kann.</translation>
    </message>
    <message>
        <source>Choose fewer segments.</source>
        <translation>Wählen Sie weniger Segmente.</translation>
    </message>
    <message>
        <source>The archive lists more than {} images of one study.</source>
        <translation>Das Archiv nennt mehr als {} Bilder einer Studie.</translation>
    </message>
    <message>
        <source>Ask for its series one by one.</source>
        <translation>Fragen Sie die Serien der Studie einzeln ab.</translation>
    </message>
    <message>
        <source>Who may send is written as TITLE, TITLE@ADDRESS or *@ADDRESS.</source>
        <translation>Wer senden darf, wird als TITEL, TITEL@ADRESSE oder *@ADRESSE geschrieben.</translation>
    </message>
    <message>
        <source>For example CT1@10.1.2.3, or *@10.1.0.0/16.</source>
        <translation>Zum Beispiel CT1@10.1.2.3 oder *@10.1.0.0/16.</translation>
    </message>
    <message>
        <source>The file has the segments on the voxels of this volume, not on those that they were drawn on.</source>
        <translation>Die Datei enthält die Segmente auf den Voxeln dieses Volumens, nicht auf denen, auf denen sie gezeichnet wurden.</translation>
    </message>
    <message>
        <source>The file has no fractions: what was half or more is the segment.</source>
        <translation>Die Datei enthält keine Anteile: was die Hälfte oder mehr war, ist das Segment.</translation>
    </message>
    <message>
        <source>Without patient and study, the file calls each segment by its code, not by its label.</source>
        <translation>Ohne Patient und Studie nennt die Datei jedes Segment nach seinem Code, nicht nach seinem Label.</translation>
    </message>
    <message>
        <source>A report holds no measurement whose value is not defined, or whose points are too far away: of {} measurements, it leaves out {}.</source>
        <translation>Ein Messbericht enthält keine Messung, deren Wert nicht definiert ist oder deren Punkte zu weit entfernt sind: von {} Messungen lässt er {} weg.</translation>
    </message>
    <message>
        <source>These images name no frame of reference, so a report cannot say where a measurement lies that is in no plane of theirs: of {} measurements, it leaves out {}.</source>
        <translation>Diese Bilder nennen kein Koordinatensystem, deshalb kann ein Messbericht nicht angeben, wo sich eine Messung befindet, die in keiner ihrer Ebenen liegt: von {} Messungen lässt er {} weg.</translation>
    </message>
    <message>
        <source>Without patient and study, the report leaves out the labels.</source>
        <translation>Ohne Patient und Studie lässt der Messbericht die Beschriftungen weg.</translation>
    </message>
    <message>
        <source>More than {} new studies were sent within {} hours.</source>
        <translation>Es wurden mehr als {} neue Studien innerhalb von {} Stunden gesendet.</translation>
    </message>
    <message>
        <source>Look at what was sent. Macula takes more later, or when it begins to receive again.</source>
        <translation>Sehen Sie nach, was gesendet wurde. Macula nimmt später wieder mehr an, oder wenn der Empfang neu begonnen wird.</translation>
    </message>
    <message>
        <source>{} objects came again with other contents. Those that came first were kept.</source>
        <translation>Objekte, die mit anderem Inhalt noch einmal gekommen sind: {}. Behalten wurde, was zuerst kam.</translation>
    </message>
    <message>
        <source>Another window of Macula, or the command macula receive, already receives at port {}.</source>
        <translation>Ein anderes Fenster von Macula oder der Befehl macula receive empfängt schon am Port {}.</translation>
    </message>
    <message>
        <source>Stop receiving there, or choose another port here and where the images come from.</source>
        <translation>Beenden Sie dort den Empfang, oder wählen Sie einen anderen Port, hier und dort, woher die Bilder kommen.</translation>
    </message>
    <message>
        <source>{} references of the manifest have no valid UID, and were left out.</source>
        <translation>Verweise des Manifests, die keine gültige UID haben: {}. Sie wurden weggelassen.</translation>
    </message>
    <message>
        <source>Ask whoever made the manifest for a new one.</source>
        <translation>Bitten Sie dort um ein neues, wo das Manifest erstellt wurde.</translation>
    </message>
    <message>
        <source>The archive {} had another address when these objects were sent to it.</source>
        <translation>Das Archiv {} hatte eine andere Adresse, als diese Objekte dorthin gesendet wurden.</translation>
    </message>
    <message>
        <source>Check its address. If it is the same archive, select the objects under Waiting for Archives and send them, or use macula pacs retry --moved.</source>
        <translation>Prüfen Sie seine Adresse. Wenn es dasselbe Archiv ist, wählen Sie die Objekte unter „Warteschlange für Archive“ aus und senden Sie sie, oder verwenden Sie macula pacs retry --moved.</translation>
    </message>
    <message>
        <source>Not all that was sent was kept. Its sender knows it.</source>
        <translation>Nicht alles, was gesendet wurde, wurde behalten. Dem Absender wurde das gemeldet.</translation>
    </message>
    <message>
        <source>Make room, or allow more in Settings, Receiving; then have it sent again.</source>
        <translation>Schaffen Sie Platz, oder erlauben Sie mehr unter Einstellungen, „Empfang“; lassen Sie es dann noch einmal senden.</translation>
    </message>
    <message>
        <source>write the segmentation</source>
        <translation>die Segmentierung zu speichern</translation>
    </message>
    <message>
        <source>write the measurements</source>
        <translation>die Messungen zu speichern</translation>
    </message>
    <message>
        <source>Another program is renewing the sign-in at this archive, and does not end.</source>
        <translation>Ein anderes Programm erneuert die Anmeldung bei diesem Archiv und wird nicht fertig.</translation>
    </message>
    <message>
        <source>Close other windows of Macula, then try again.</source>
        <translation>Schließen Sie andere Fenster von Macula, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The sign-in was cancelled.</source>
        <translation>Die Anmeldung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The file of this segmentation is another one by now.</source>
        <translation>Die Datei dieser Segmentierung ist inzwischen eine andere.</translation>
    </message>
    <message>
        <source>{} segments have no voxel in this volume, and are left out.</source>
        <translation>Ohne Voxel in diesem Volumen, und deshalb ausgelassen: {} Segmente.</translation>
    </message>
    <message>
        <source>Each image of this volume says that it is a series of its own, so an object for the archive would refer to the wrong one.</source>
        <translation>Jedes Bild dieses Volumens gibt sich als eigene Serie aus; ein Objekt für das Archiv verwiese deshalb auf die falsche.</translation>
    </message>
    <message>
        <source>Save a view or a table instead, or ask for images with the right identifiers.</source>
        <translation>Speichern Sie stattdessen eine Ansicht oder eine Tabelle, oder bitten Sie um Bilder mit den richtigen Kennungen.</translation>
    </message>
    <message>
        <source>This version cannot show an image in these colours.</source>
        <translation>Diese Version kann ein Bild in diesen Farben nicht zeigen.</translation>
    </message>
    <message>
        <source>Export it as RGB.</source>
        <translation>Exportieren Sie es als RGB.</translation>
    </message>
    <message>
        <source>The image cannot be read.</source>
        <translation>Das Bild kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Shown as images, not in 3D</source>
        <translation>Als Bilder gezeigt, nicht in 3D</translation>
    </message>
    <message>
        <source>Wheel, arrows, Space on images</source>
        <translation>Rad, Pfeile, Leertaste auf Bildern</translation>
    </message>
    <message>
        <source>Next image or frame; play the loop, or stop; Home and End: to the ends</source>
        <translation>Nächstes Bild; Schleife abspielen oder anhalten; Pos1 und Ende: zu den Enden</translation>
    </message>
    <message>
        <source>Drag on images</source>
        <translation>Ziehen auf Bildern</translation>
    </message>
    <message>
        <source>I, R, M, F, Esc on images</source>
        <translation>I, R, M, F, Esc auf Bildern</translation>
    </message>
    <message>
        <source>Invert, turn clockwise, mirror, fit; back to the volume</source>
        <translation>Invertieren, im Uhrzeigersinn drehen, spiegeln, einpassen; zurück zum Volumen</translation>
    </message>
    <message>
        <source>The structure set cannot be read.</source>
        <translation>Das Struktur-Set kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>read a structure set</source>
        <translation>ein Struktur-Set zu lesen</translation>
    </message>
    <message>
        <source>Reading {} contoured regions</source>
        <translation>{} konturierte Regionen werden gelesen</translation>
    </message>
    <message>
        <source>Reading the segmentation was cancelled.</source>
        <translation>Das Lesen der Segmentierung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>It has no contours that enclose anything.</source>
        <translation>Es hat keine Konturen, die etwas umschließen.</translation>
    </message>
    <message>
        <source>It is drawn as contours: volumes come from their areas, voxels from what they enclose.</source>
        <translation>Es ist als Konturen gezeichnet: Volumina ergeben sich aus deren Flächen, Voxel aus dem, was sie umschließen.</translation>
    </message>
    <message>
        <source>Some contours lie farther apart than slices; slices between them show the nearest.</source>
        <translation>Manche Konturen liegen weiter auseinander als die Schichten; Schichten dazwischen zeigen die nächste.</translation>
    </message>
    <message>
        <source>{} contours are not parallel to the slices, and are left out.</source>
        <translation>Nicht parallel zu den Schichten, und deshalb ausgelassen: {} Konturen.</translation>
    </message>
    <message>
        <source>{} points and open lines enclose nothing, and are left out.</source>
        <translation>Punkte und offene Linien, die nichts umschließen, und deshalb ausgelassen: {}.</translation>
    </message>
    <message>
        <source>{} contours cannot be read, or are too long: regions may lack parts.</source>
        <translation>Nicht lesbar oder zu lang: {} Konturen. Regionen können unvollständig sein.</translation>
    </message>
    <message>
        <source>Contours of some regions lie at uneven distances; their volumes take each for the usual one.</source>
        <translation>Konturen mancher Regionen haben ungleiche Abstände; ihr Volumen rechnet jede mit dem üblichen.</translation>
    </message>
    <message>
        <source>{} regions lie in another coordinate system, and are not shown.</source>
        <translation>In einem anderen Koordinatensystem, und deshalb nicht gezeigt: {} Regionen.</translation>
    </message>
    <message>
        <source>{} regions have no number of their own, and are left out.</source>
        <translation>Ohne eigene Nummer, und deshalb ausgelassen: {} Regionen.</translation>
    </message>
    <message>
        <source>The phases have values of different units.</source>
        <translation>Die Phasen haben Werte in verschiedenen Einheiten.</translation>
    </message>
    <message>
        <source>Measure each phase by itself.</source>
        <translation>Messen Sie jede Phase für sich.</translation>
    </message>
    <message>
        <source>The curve was cancelled.</source>
        <translation>Die Kurve wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Draw an ellipse (E) on a slice: the curve has the mean of the values in it.</source>
        <translation>Zeichnen Sie auf einer Schicht eine Ellipse (E): Die Kurve zeigt den Mittelwert darin.</translation>
    </message>
    <message>
        <source>a turn, not all zeros</source>
        <translation>eine Drehung, nicht nur Nullen</translation>
    </message>
    <message>
        <source>The places are too far apart to look for a way between them.</source>
        <translation>Die Stellen liegen zu weit auseinander, um einen Weg zwischen ihnen zu suchen.</translation>
    </message>
    <message>
        <source>Set a place between them.</source>
        <translation>Setzen Sie eine Stelle dazwischen.</translation>
    </message>
    <message>
        <source>Looking for the way of the vessel was cancelled.</source>
        <translation>Die Suche nach dem Verlauf des Gefäßes wurde abgebrochen.</translation>
    </message>
    <message>
        <source>A way needs two places in the volume.</source>
        <translation>Ein Weg braucht zwei Stellen im Volumen.</translation>
    </message>
    <message>
        <source>Set a place at each end of the vessel with the curve tool.</source>
        <translation>Setzen Sie mit dem Kurvenwerkzeug an jedes Ende des Gefäßes eine Stelle.</translation>
    </message>
    <message>
        <source>The curved plane was cancelled.</source>
        <translation>Die gekrümmte Ebene wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is no memory for this picture.</source>
        <translation>Für dieses Bild ist kein Speicher da.</translation>
    </message>
    <message>
        <source>Turn the planes about the cross-hair; with Shift, in steps of 15 degrees</source>
        <translation>Die Ebenen um das Fadenkreuz drehen; mit Umschalt in Schritten von 15 Grad</translation>
    </message>
    <message>
        <source>Planes that were turned are straight again</source>
        <translation>Gedrehte Ebenen sind wieder gerade</translation>
    </message>
    <message>
        <source>Panel: curved plane along the points of the curve tool</source>
        <translation>Feld: gekrümmte Ebene entlang der Punkte des Kurvenwerkzeugs</translation>
    </message>
    <message>
        <source>Type the width and the level of the window</source>
        <translation>Weite und Lage der Fensterung eingeben</translation>
    </message>
    <message>
        <source>Ctrl+C on slices</source>
        <translation>Strg+C auf Schichten</translation>
    </message>
    <message>
        <source>Copy the pane as a picture, with its measurements</source>
        <translation>Das Bildfeld als Bild kopieren, mit seinen Messungen</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>ein Punkt</translation>
    </message>
    <message>
        <source>{} points</source>
        <translation>{} Punkte</translation>
    </message>
    <message>
        <source>a line of {} points</source>
        <translation>eine Linie aus {} Punkten</translation>
    </message>
    <message>
        <source>a polygon of {} corners</source>
        <translation>ein Vieleck mit {} Ecken</translation>
    </message>
    <message>
        <source>a circle</source>
        <translation>ein Kreis</translation>
    </message>
    <message>
        <source>an ellipse</source>
        <translation>eine Ellipse</translation>
    </message>
    <message>
        <source>an ellipsoid</source>
        <translation>ein Ellipsoid</translation>
    </message>
    <message>
        <source>a shape of {} points</source>
        <translation>eine Form aus {} Punkten</translation>
    </message>
    <message>
        <source>A time range: {}</source>
        <translation>Ein Zeitraum: {}</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>An object that the report does not name</source>
        <translation>Ein Objekt, das der Befund nicht nennt</translation>
    </message>
    <message>
        <source>A shape whose points cannot be read</source>
        <translation>Eine Form, deren Punkte nicht gelesen werden können</translation>
    </message>
    <message>
        <source>Drawn in space: {}</source>
        <translation>Im Raum gezeichnet: {}</translation>
    </message>
    <message>
        <source>Drawn on an image: {}</source>
        <translation>Auf einem Bild gezeichnet: {}</translation>
    </message>
    <message>
        <source>See an item that is not there</source>
        <translation>Siehe einen Eintrag, den es nicht gibt</translation>
    </message>
    <message>
        <source>See item {}</source>
        <translation>Siehe Eintrag {}</translation>
    </message>
    <message>
        <source>See: {}</source>
        <translation>Siehe: {}</translation>
    </message>
    <message>
        <source>The document is larger than what is shown here: the rest of it is missing below.</source>
        <translation>Das Dokument ist größer als das, was hier gezeigt wird: Der Rest fehlt unten.</translation>
    </message>
    <message>
        <source>One entry of the document has no value.</source>
        <translation>Ein Eintrag des Dokuments hat keinen Wert.</translation>
    </message>
    <message>
        <source>{} entries of the document have no value.</source>
        <translation>{} Einträge des Dokuments haben keinen Wert.</translation>
    </message>
    <message>
        <source>One entry of the document is of a kind that is not shown.</source>
        <translation>Ein Eintrag des Dokuments ist von einer Art, die nicht gezeigt wird.</translation>
    </message>
    <message>
        <source>{} entries of the document are of kinds that are not shown.</source>
        <translation>{} Einträge des Dokuments sind von Arten, die nicht gezeigt werden.</translation>
    </message>
    <message>
        <source>One text of the document is too long to be shown.</source>
        <translation>Ein Text des Dokuments ist zu lang, um gezeigt zu werden.</translation>
    </message>
    <message>
        <source>{} texts of the document are too long to be shown.</source>
        <translation>{} Texte des Dokuments sind zu lang, um gezeigt zu werden.</translation>
    </message>
    <message>
        <source>One number of the document is no number; it is shown as it is.</source>
        <translation>Eine Zahl des Dokuments ist keine Zahl; sie wird gezeigt, wie sie ist.</translation>
    </message>
    <message>
        <source>{} numbers of the document are no numbers; they are shown as they are.</source>
        <translation>{} Zahlen des Dokuments sind keine Zahlen; sie werden gezeigt, wie sie sind.</translation>
    </message>
    <message>
        <source>One shape of the document has points that cannot be read.</source>
        <translation>Eine Form des Dokuments hat Punkte, die nicht gelesen werden können.</translation>
    </message>
    <message>
        <source>{} shapes of the document have points that cannot be read.</source>
        <translation>{} Formen des Dokuments haben Punkte, die nicht gelesen werden können.</translation>
    </message>
    <message>
        <source>One reference of the document leads nowhere.</source>
        <translation>Ein Verweis des Dokuments führt ins Leere.</translation>
    </message>
    <message>
        <source>{} references of the document lead nowhere.</source>
        <translation>{} Verweise des Dokuments führen ins Leere.</translation>
    </message>
    <message>
        <source>The document names no patient.</source>
        <translation>Das Dokument nennt keinen Patienten.</translation>
    </message>
    <message>
        <source>The document has no date.</source>
        <translation>Das Dokument hat kein Datum.</translation>
    </message>
    <message>
        <source>A file: {}, {:.1f} kB</source>
        <translation>Eine Datei: {}, {:.1f} kB</translation>
    </message>
    <message>
        <source>Inferred from</source>
        <translation>Abgeleitet aus</translation>
    </message>
    <message>
        <source>Inferred from: {}</source>
        <translation>Abgeleitet aus: {}</translation>
    </message>
    <message>
        <source>Note: {}</source>
        <translation>Hinweis: {}</translation>
    </message>
    <message>
        <source>(no heading)</source>
        <translation>(ohne Überschrift)</translation>
    </message>
    <message>
        <source>An object</source>
        <translation>Ein Objekt</translation>
    </message>
    <message>
        <source>{} image</source>
        <translation>{}-Bild</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>{}, frame {}</source>
        <translation>{}, Einzelbild {}</translation>
    </message>
    <message>
        <source>{}, frames {}</source>
        <translation>{}, Einzelbilder {}</translation>
    </message>
    <message>
        <source>The plan has brachytherapy, which is not shown here.</source>
        <translation>Der Plan enthält Brachytherapie, die hier nicht gezeigt wird.</translation>
    </message>
    <message>
        <source>Some numbers of the plan cannot be read, and are left out.</source>
        <translation>Einige Zahlen des Plans können nicht gelesen werden und fehlen hier.</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Intent</source>
        <translation>Absicht</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Made on</source>
        <translation>Erstellt auf</translation>
    </message>
    <message>
        <source>Prescription</source>
        <translation>Verordnung</translation>
    </message>
    <message>
        <source>Dose reference {}</source>
        <translation>Dosisreferenz {}</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Defined by</source>
        <translation>Festgelegt durch</translation>
    </message>
    <message>
        <source>Prescribed dose</source>
        <translation>Verordnete Dosis</translation>
    </message>
    <message>
        <source>Least dose</source>
        <translation>Mindestdosis</translation>
    </message>
    <message>
        <source>Greatest dose</source>
        <translation>Höchstdosis</translation>
    </message>
    <message>
        <source>Greatest dose of the organ</source>
        <translation>Höchstdosis des Organs</translation>
    </message>
    <message>
        <source>Greatest dose that may be delivered</source>
        <translation>Höchste zu verabreichende Dosis</translation>
    </message>
    <message>
        <source>Dose</source>
        <translation>Dosis</translation>
    </message>
    <message>
        <source>The plan names no prescribed dose.</source>
        <translation>Der Plan nennt keine verordnete Dosis.</translation>
    </message>
    <message>
        <source>Fraction group {}</source>
        <translation>Fraktionsgruppe {}</translation>
    </message>
    <message>
        <source>Planned fractions</source>
        <translation>Geplante Fraktionen</translation>
    </message>
    <message>
        <source>Beams</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Brachytherapy</source>
        <translation>Brachytherapie</translation>
    </message>
    <message>
        <source>It has some, which is not shown here.</source>
        <translation>Ist enthalten und wird hier nicht gezeigt.</translation>
    </message>
    <message>
        <source>Beam {}</source>
        <translation>Feld {}</translation>
    </message>
    <message>
        <source>Beam {}: {}</source>
        <translation>Feld {}: {}</translation>
    </message>
    <message>
        <source>Delivery</source>
        <translation>Anwendung</translation>
    </message>
    <message>
        <source>Radiation</source>
        <translation>Strahlung</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Control points</source>
        <translation>Kontrollpunkte</translation>
    </message>
    <message>
        <source>The plan has none for this beam.</source>
        <translation>Der Plan hat keine für dieses Feld.</translation>
    </message>
    <message>
        <source>Wedges</source>
        <translation>Keile</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>Boli</source>
        <translation>Boli</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Dose rate</source>
        <translation>Dosisleistung</translation>
    </message>
    <message>
        <source>Gantry angle</source>
        <translation>Gantrywinkel</translation>
    </message>
    <message>
        <source>Collimator angle</source>
        <translation>Kollimatorwinkel</translation>
    </message>
    <message>
        <source>Couch angle</source>
        <translation>Tischwinkel</translation>
    </message>
    <message>
        <source>Isocentre</source>
        <translation>Isozentrum</translation>
    </message>
    <message>
        <source>from {} to {}, clockwise</source>
        <translation>von {} bis {}, im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>from {} to {}, counter-clockwise</source>
        <translation>von {} bis {}, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>from {} to {}</source>
        <translation>von {} bis {}</translation>
    </message>
    <message>
        <source>Meterset</source>
        <translation>Monitoreinheiten</translation>
    </message>
    <message>
        <source>In no fraction group.</source>
        <translation>In keiner Fraktionsgruppe.</translation>
    </message>
    <message>
        <source>{} in fraction group {}</source>
        <translation>{} in Fraktionsgruppe {}</translation>
    </message>
    <message>
        <source>Dose of the beam</source>
        <translation>Dosis des Feldes</translation>
    </message>
    <message>
        <source>Rejected: it must not be used.</source>
        <translation>Abgelehnt: Er darf nicht verwendet werden.</translation>
    </message>
    <message>
        <source>Not approved by anybody.</source>
        <translation>Von niemandem freigegeben.</translation>
    </message>
    <message>
        <source>The plan does not say whether anybody approved it.</source>
        <translation>Der Plan sagt nicht, ob ihn jemand freigegeben hat.</translation>
    </message>
    <message>
        <source>Approved.</source>
        <translation>Freigegeben.</translation>
    </message>
    <message>
        <source>Approved by {}.</source>
        <translation>Freigegeben von {}.</translation>
    </message>
    <message>
        <source>Approved by {} on {}.</source>
        <translation>Freigegeben von {} am {}.</translation>
    </message>
    <message>
        <source>What the plan says is shown for reading. Nothing of it may be used for treatment.</source>
        <translation>Was der Plan sagt, wird zum Lesen gezeigt. Nichts davon darf zur Behandlung verwendet werden.</translation>
    </message>
    <message>
        <source>There is not enough memory for the document.</source>
        <translation>Für das Dokument reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>The file is no DICOM file.</source>
        <translation>Die Datei ist keine DICOM-Datei.</translation>
    </message>
    <message>
        <source>Choose a report, a plan or another document in DICOM.</source>
        <translation>Wählen Sie einen Befund, einen Plan oder ein anderes Dokument in DICOM.</translation>
    </message>
    <message>
        <source>The document is damaged, or nested deeper than any real one, and cannot be read.</source>
        <translation>Das Dokument ist beschädigt oder tiefer verschachtelt als jedes echte und kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The document holds no file, or one that is too large to be read.</source>
        <translation>Das Dokument enthält keine Datei oder eine, die zu groß zum Lesen ist.</translation>
    </message>
    <message>
        <source>Get the document again from where it was made.</source>
        <translation>Holen Sie das Dokument noch einmal von dort, wo es entstand.</translation>
    </message>
    <message>
        <source>The document says that its file is longer or shorter than it is: the file may be cut off.</source>
        <translation>Das Dokument gibt für seine Datei eine andere Länge an, als sie hat: Die Datei kann abgeschnitten sein.</translation>
    </message>
    <message>
        <source>The document calls its file a PDF, but the file does not begin as one.</source>
        <translation>Das Dokument nennt seine Datei ein PDF, aber sie beginnt nicht wie eines.</translation>
    </message>
    <message>
        <source>Verified.</source>
        <translation>Verifiziert.</translation>
    </message>
    <message>
        <source>Not verified by anybody.</source>
        <translation>Von niemandem verifiziert.</translation>
    </message>
    <message>
        <source>The document says another character set than it has: letters may be wrong.</source>
        <translation>Das Dokument nennt einen anderen Zeichensatz, als es hat: Buchstaben können falsch sein.</translation>
    </message>
    <message>
        <source>The file is no report, plan or other document.</source>
        <translation>Die Datei ist kein Befund, Plan oder anderes Dokument.</translation>
    </message>
    <message>
        <source>read the document</source>
        <translation>das Dokument zu lesen</translation>
    </message>
    <message>
        <source>The document does not say whether anybody verified it.</source>
        <translation>Das Dokument sagt nicht, ob es jemand verifiziert hat.</translation>
    </message>
    <message>
        <source>The document names who verified it, but does not say that it is verified.</source>
        <translation>Das Dokument nennt, wer es verifiziert hat, sagt aber nicht, dass es verifiziert ist.</translation>
    </message>
    <message>
        <source>The document says that it is verified, and not by whom.</source>
        <translation>Das Dokument sagt, dass es verifiziert ist, aber nicht, von wem.</translation>
    </message>
    <message>
        <source>Verified on {}.</source>
        <translation>Verifiziert am {}.</translation>
    </message>
    <message>
        <source>Verified by {}.</source>
        <translation>Verifiziert von {}.</translation>
    </message>
    <message>
        <source>Verified by {} on {}.</source>
        <translation>Verifiziert von {} am {}.</translation>
    </message>
    <message>
        <source>Complete.</source>
        <translation>Vollständig.</translation>
    </message>
    <message>
        <source>Partial: some of its content may be missing.</source>
        <translation>Teilweise: Ein Teil des Inhalts kann fehlen.</translation>
    </message>
    <message>
        <source>The document does not say whether it is complete.</source>
        <translation>Das Dokument sagt nicht, ob es vollständig ist.</translation>
    </message>
    <message>
        <source>Preliminary.</source>
        <translation>Vorläufig.</translation>
    </message>
    <message>
        <source>Final.</source>
        <translation>Endgültig.</translation>
    </message>
    <message>
        <source>It follows an earlier document, which it amends or replaces.</source>
        <translation>Es folgt auf ein früheres Dokument, das es ergänzt oder ersetzt.</translation>
    </message>
    <message>
        <source>The document has no title.</source>
        <translation>Das Dokument hat keinen Titel.</translation>
    </message>
    <message>
        <source>The document does not begin as the standard wants it.</source>
        <translation>Das Dokument beginnt nicht so, wie es der Standard verlangt.</translation>
    </message>
    <message>
        <source>The document is empty.</source>
        <translation>Das Dokument ist leer.</translation>
    </message>
    <message>
        <source>annotations of other kinds</source>
        <translation>Anmerkungen anderer Art</translation>
    </message>
    <message>
        <source>a shutter of another kind</source>
        <translation>eine Blende anderer Art</translation>
    </message>
    <message>
        <source>Open the archive itself if it is a ZIP or tar file; otherwise unpack it, and open the folder with what was in it.</source>
        <translation>Das Archiv selbst öffnen, wenn es eine ZIP- oder tar-Datei ist; sonst entpacken und den Ordner mit dem Inhalt öffnen.</translation>
    </message>
    <message>
        <source>There are no images to show on their own.</source>
        <translation>Es gibt keine Bilder, die für sich gezeigt werden.</translation>
    </message>
    <message>
        <source>Name a series of the list of macula info with --series.</source>
        <translation>Nennen Sie mit --series eine Serie aus der Liste von macula info.</translation>
    </message>
    <message>
        <source>Choose one of its images with --series and --image.</source>
        <translation>Wählen Sie mit --series und --image eines seiner Bilder.</translation>
    </message>
    <message>
        <source>Its graphics and texts are not drawn here; the window shows them.</source>
        <translation>Seine Grafiken und Texte sind hier nicht gezeichnet; das Fenster zeigt sie.</translation>
    </message>
    <message>
        <source>All of the image is drawn, not its displayed area alone.</source>
        <translation>Das ganze Bild ist gezeichnet, nicht nur sein Anzeigebereich.</translation>
    </message>
    <message>
        <source>The window shows no values.</source>
        <translation>Das Fenster zeigt keine Werte.</translation>
    </message>
    <message>
        <source>Give its centre and its width, which is above 0: --window 40,400.</source>
        <translation>Geben Sie Mitte und Breite an, die über 0 liegt: --window 40,400.</translation>
    </message>
    <message>
        <source>The image is in colours, which no window changes.</source>
        <translation>Das Bild ist farbig; kein Fenster ändert das.</translation>
    </message>
    <message>
        <source>A shutter hides part of the image.</source>
        <translation>Eine Blende verdeckt einen Teil des Bildes.</translation>
    </message>
    <message>
        <source>The series has {} images.</source>
        <translation>Die Serie hat {} Bilder.</translation>
    </message>
    <message>
        <source>Give one of them with --image, from 1.</source>
        <translation>Nennen Sie eines davon mit --image, ab 1.</translation>
    </message>
    <message>
        <source>Its pixels are {:.3g} times as high as wide; those of the picture are square.</source>
        <translation>Seine Pixel sind {:.3g}-mal so hoch wie breit; die des Bildes sind quadratisch.</translation>
    </message>
    <message>
        <source>The program has to write the number of a segment into each voxel of the volume it got.</source>
        <translation>Das Programm muss in jedes Voxel des Volumens, das es bekam, die Nummer eines Segments schreiben.</translation>
    </message>
    <message>
        <source>The result has other voxels than the volume, or lies elsewhere.</source>
        <translation>Das Ergebnis hat andere Voxel als das Volumen, oder es liegt woanders.</translation>
    </message>
    <message>
        <source>The result has no segment: all of its voxels are 0.</source>
        <translation>Das Ergebnis hat kein Segment: Alle seine Voxel sind 0.</translation>
    </message>
    <message>
        <source>There is not enough memory for the segments of this result.</source>
        <translation>Für die Segmente dieses Ergebnisses reicht der Arbeitsspeicher nicht.</translation>
    </message>
    <message>
        <source>The own segments of this study cannot be read.</source>
        <translation>Die eigenen Segmente dieser Studie lassen sich nicht lesen.</translation>
    </message>
    <message>
        <source>They stay stored as they are; a newer version of the program may read them.</source>
        <translation>Sie bleiben gespeichert, wie sie sind; eine neuere Version des Programms kann sie vielleicht lesen.</translation>
    </message>
    <message>
        <source>The own segments of this study are too large to be kept with it.</source>
        <translation>Die eigenen Segmente dieser Studie sind zu groß, um mit ihr aufbewahrt zu werden.</translation>
    </message>
    <message>
        <source>Save them as a file, or make them smoother: single voxels take most of the room.</source>
        <translation>Speichern Sie sie als Datei, oder glätten Sie sie: Einzelne Voxel brauchen den meisten Platz.</translation>
    </message>
    <message>
        <source>There is not enough memory for the own segments of this study.</source>
        <translation>Für die eigenen Segmente dieser Studie reicht der Arbeitsspeicher nicht.</translation>
    </message>
    <message>
        <source>A DICOM segmentation refers to DICOM images, and these are none.</source>
        <translation>Eine DICOM-Segmentierung verweist auf DICOM-Bilder, und das sind keine.</translation>
    </message>
    <message>
        <source>Write a .nii.gz file.</source>
        <translation>Schreiben Sie eine .nii.gz-Datei.</translation>
    </message>
    <message>
        <source>The ending of the file says no format.</source>
        <translation>Die Endung der Datei nennt kein Format.</translation>
    </message>
    <message>
        <source>Choose .nii.gz or another volume file, .dcm, .stl or .glb.</source>
        <translation>Wählen Sie .nii.gz oder eine andere Volumendatei, .dcm, .stl oder .glb.</translation>
    </message>
    <message>
        <source>The segment has no voxel; nothing was written.</source>
        <translation>Das Segment hat kein Voxel; es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>Choose other values, or leave steps out.</source>
        <translation>Wählen Sie andere Werte, oder lassen Sie Schritte weg.</translation>
    </message>
    <message>
        <source>The point lies outside of the volume.</source>
        <translation>Der Punkt liegt außerhalb des Volumens.</translation>
    </message>
    <message>
        <source>Give it in patient coordinates (LPS), in mm.</source>
        <translation>Geben Sie ihn in Patientenkoordinaten (LPS) in mm an.</translation>
    </message>
    <message>
        <source>The value at the point is not within the threshold.</source>
        <translation>Der Wert an dem Punkt liegt nicht innerhalb der Schwellen.</translation>
    </message>
    <message>
        <source>Choose another point, or a wider threshold.</source>
        <translation>Wählen Sie einen anderen Punkt oder weitere Schwellen.</translation>
    </message>
    <message>
        <source>Nothing says where the segment begins.</source>
        <translation>Nichts sagt, wo das Segment beginnt.</translation>
    </message>
    <message>
        <source>Give a threshold, or a point to grow from with a tolerance.</source>
        <translation>Geben Sie Schwellen an oder einen Punkt mit einer Toleranz, von dem aus es wächst.</translation>
    </message>
    <message>
        <source>No segment is chosen whose surface could be saved.</source>
        <translation>Es ist kein Segment gewählt, dessen Oberfläche gespeichert werden könnte.</translation>
    </message>
    <message>
        <source>Select one in the list.</source>
        <translation>Wählen Sie eines in der Liste.</translation>
    </message>
    <message>
        <source>{} triangles, smoothed; patient coordinates (LPS) in mm.</source>
        <translation>{} Dreiecke, geglättet; Patientenkoordinaten (LPS) in mm.</translation>
    </message>
    <message>
        <source>Its size is an estimate: the size of a pixel is not calibrated.</source>
        <translation>Die Größe ist geschätzt: Die Pixelgröße ist nicht kalibriert.</translation>
    </message>
    <message>
        <source>Draw one first.</source>
        <translation>Zeichnen Sie zuerst eines.</translation>
    </message>
    <message>
        <source>The file has the numbers of the segments, not their names.</source>
        <translation>Die Datei enthält die Nummern der Segmente, nicht ihre Namen.</translation>
    </message>
    <message>
        <source>{} voxels are in several segments; the file has them in the last one.</source>
        <translation>{} Voxel liegen in mehreren Segmenten; in der Datei sind sie im letzten.</translation>
    </message>
    <message>
        <source>write the segments</source>
        <translation>die Segmente zu schreiben</translation>
    </message>
    <message>
        <source>Shapes that the report draws on images that are not open, and that were left out: {}.</source>
        <translation>Formen, die der Befund auf Bildern zeichnet, die nicht offen sind, und die ausgelassen wurden: {}.</translation>
    </message>
    <message>
        <source>Shapes on images that do not say where they lie, and that were left out: {}.</source>
        <translation>Formen auf Bildern, die nicht sagen, wo sie liegen, und die ausgelassen wurden: {}.</translation>
    </message>
    <message>
        <source>Shapes whose points cannot be right, and that were left out: {}.</source>
        <translation>Formen, deren Punkte nicht stimmen können, und die ausgelassen wurden: {}.</translation>
    </message>
    <message>
        <source>Measurements that are there already, and that were not taken again: {}.</source>
        <translation>Messungen, die schon da sind und nicht noch einmal übernommen wurden: {}.</translation>
    </message>
    <message>
        <source>The report has too many measurements; left out were {}.</source>
        <translation>Der Befund hat zu viele Messungen; ausgelassen wurden {}.</translation>
    </message>
    <message>
        <source>Macula measures another value between the same points than the report says: {} measurements. Compare them with the report.</source>
        <translation>Macula misst zwischen denselben Punkten einen anderen Wert, als der Befund nennt: {} Messungen. Vergleichen Sie sie mit dem Befund.</translation>
    </message>
    <message>
        <source>Open the study that the report is about.</source>
        <translation>Öffnen Sie die Studie, um die es im Befund geht.</translation>
    </message>
    <message>
        <source>There are no images to measure on.</source>
        <translation>Es gibt keine Bilder, auf denen gemessen werden kann.</translation>
    </message>
    <message>
        <source>The images of the open study cannot be read again.</source>
        <translation>Die Bilder der geöffneten Studie können nicht noch einmal gelesen werden.</translation>
    </message>
    <message>
        <source>The report is of another patient than the study that is open.</source>
        <translation>Der Befund gehört zu einem anderen Patienten als die geöffnete Studie.</translation>
    </message>
    <message>
        <source>The report belongs to another study than the one that is open.</source>
        <translation>Der Befund gehört zu einer anderen Studie als der geöffneten.</translation>
    </message>
    <message>
        <source>Open the series that it was measured on.</source>
        <translation>Öffnen Sie die Serie, auf der gemessen wurde.</translation>
    </message>
    <message>
        <source>&quot;percent&quot; or &quot;dose&quot;</source>
        <translation>&quot;percent&quot; oder &quot;dose&quot;</translation>
    </message>
    <message>
        <source>Looking for connected parts</source>
        <translation>Zusammenhängende Teile werden gesucht</translation>
    </message>
    <message>
        <source>There is not enough memory to look for connected parts.</source>
        <translation>Um zusammenhängende Teile zu suchen, reicht der Arbeitsspeicher nicht.</translation>
    </message>
    <message>
        <source>That length cannot be used: {} mm.</source>
        <translation>Diese Länge ist nicht brauchbar: {} mm.</translation>
    </message>
    <message>
        <source>Enter one above 0, and of at most {} mm.</source>
        <translation>Geben Sie eine über 0 und von höchstens {} mm ein.</translation>
    </message>
    <message>
        <source>There is not enough memory to change the segment.</source>
        <translation>Um das Segment zu ändern, reicht der Arbeitsspeicher nicht.</translation>
    </message>
    <message>
        <source>Close other programs, or make the segment smaller first.</source>
        <translation>Schließen Sie andere Programme, oder verkleinern Sie zuerst das Segment.</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Growing the segment</source>
        <translation>Das Segment wird vergrößert</translation>
    </message>
    <message>
        <source>Shrinking the segment</source>
        <translation>Das Segment wird verkleinert</translation>
    </message>
    <message>
        <source>There are no empty slices between others that are painted.</source>
        <translation>Zwischen bemalten Schichten liegen keine leeren.</translation>
    </message>
    <message>
        <source>Paint in one slice alone, then in another farther away, and fill between them.</source>
        <translation>Malen Sie nur in einer Schicht, dann in einer weiter entfernten, und füllen Sie dazwischen.</translation>
    </message>
    <message>
        <source>Filling between slices</source>
        <translation>Zwischen Schichten wird gefüllt</translation>
    </message>
    <message>
        <source>Reading the values of the segment</source>
        <translation>Die Werte des Segments werden gelesen</translation>
    </message>
    <message>
        <source>The segment has no voxel, and so no surface.</source>
        <translation>Das Segment hat kein Voxel und damit keine Oberfläche.</translation>
    </message>
    <message>
        <source>Draw it first, or choose another one.</source>
        <translation>Zeichnen Sie es zuerst, oder wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>Making a surface</source>
        <translation>Eine Oberfläche wird berechnet</translation>
    </message>
    <message>
        <source>The surface of this segment has more than {} triangles.</source>
        <translation>Die Oberfläche dieses Segments hat mehr als {} Dreiecke.</translation>
    </message>
    <message>
        <source>Smooth the segment, or keep its largest part.</source>
        <translation>Glätten Sie das Segment, oder behalten Sie nur seinen größten Teil.</translation>
    </message>
    <message>
        <source>There is not enough memory for the surface of this segment.</source>
        <translation>Für die Oberfläche dieses Segments reicht der Arbeitsspeicher nicht.</translation>
    </message>
    <message>
        <source>Close other programs, or smooth the segment first.</source>
        <translation>Schließen Sie andere Programme, oder glätten Sie zuerst das Segment.</translation>
    </message>
    <message>
        <source>A surface is written as .stl or .glb.</source>
        <translation>Eine Oberfläche wird als .stl oder .glb geschrieben.</translation>
    </message>
    <message>
        <source>Choose one of these endings.</source>
        <translation>Wählen Sie eine dieser Endungen.</translation>
    </message>
    <message>
        <source>The surface has too many triangles for a file.</source>
        <translation>Die Oberfläche hat zu viele Dreiecke für eine Datei.</translation>
    </message>
    <message>
        <source>There is not enough memory to write this surface.</source>
        <translation>Um diese Oberfläche zu schreiben, reicht der Arbeitsspeicher nicht.</translation>
    </message>
    <message>
        <source>There is not enough memory to segment this volume.</source>
        <translation>Um dieses Volumen zu segmentieren, reicht der Arbeitsspeicher nicht.</translation>
    </message>
    <message>
        <source>Close other programs, or segment within a smaller region.</source>
        <translation>Schließen Sie andere Programme, oder segmentieren Sie in einem kleineren Bereich.</translation>
    </message>
    <message>
        <source>Choose a point within it.</source>
        <translation>Wählen Sie einen Punkt darin.</translation>
    </message>
    <message>
        <source>The point lies outside of the region to grow in.</source>
        <translation>Der Punkt liegt außerhalb des Bereichs, in dem gewachsen werden soll.</translation>
    </message>
    <message>
        <source>Choose a point within it, or grow in the whole volume.</source>
        <translation>Wählen Sie einen Punkt darin, oder lassen Sie im ganzen Volumen wachsen.</translation>
    </message>
    <message>
        <source>The tolerance is not a number from 0.</source>
        <translation>Die Toleranz ist keine Zahl ab 0.</translation>
    </message>
    <message>
        <source>Enter one in the unit of the volume.</source>
        <translation>Geben Sie eine in der Einheit des Volumens ein.</translation>
    </message>
    <message>
        <source>Nothing was measured at that point.</source>
        <translation>An diesem Punkt wurde nichts gemessen.</translation>
    </message>
    <message>
        <source>Choose a point within the patient.</source>
        <translation>Wählen Sie einen Punkt im Patienten.</translation>
    </message>
    <message>
        <source>The point differs from its surroundings by more than the tolerance.</source>
        <translation>Der Punkt weicht von seiner Umgebung um mehr als die Toleranz ab.</translation>
    </message>
    <message>
        <source>Raise the tolerance, or choose a point away from an edge.</source>
        <translation>Erhöhen Sie die Toleranz, oder wählen Sie einen Punkt abseits einer Kante.</translation>
    </message>
    <message>
        <source>The lower threshold is above the upper one, or one of them is no number.</source>
        <translation>Die untere Schwelle liegt über der oberen, oder eine von beiden ist keine Zahl.</translation>
    </message>
    <message>
        <source>Enter two values in the unit of the volume, the lower one first.</source>
        <translation>Geben Sie zwei Werte in der Einheit des Volumens ein, den kleineren zuerst.</translation>
    </message>
    <message>
        <source>Looking for values</source>
        <translation>Werte werden gesucht</translation>
    </message>
    <message>
        <source>Growing a region</source>
        <translation>Ein Bereich wächst</translation>
    </message>
    <message>
        <source>Segmenting was cancelled.</source>
        <translation>Das Segmentieren wurde abgebrochen.</translation>
    </message>
    <message>
        <source>image {}</source>
        <translation>Bild {}</translation>
    </message>
    <message>
        <source>an image without a number</source>
        <translation>ein Bild ohne Nummer</translation>
    </message>
    <message>
        <source>frame {}</source>
        <translation>Einzelbild {}</translation>
    </message>
    <message>
        <source>The folder holds no report, plan or other document.</source>
        <translation>Der Ordner enthält keinen Befund, keinen Plan und kein anderes Dokument.</translation>
    </message>
    <message>
        <source>macula info lists what is in it.</source>
        <translation>macula info führt auf, was darin ist.</translation>
    </message>
    <message>
        <source>Several documents there hold a file.</source>
        <translation>Mehrere Dokumente dort enthalten eine Datei.</translation>
    </message>
    <message>
        <source>Give the path of one of them instead of the folder.</source>
        <translation>Geben Sie statt des Ordners den Pfad eines davon an.</translation>
    </message>
    <message>
        <source>No document there holds a file, such as a PDF.</source>
        <translation>Kein Dokument dort enthält eine Datei wie ein PDF.</translation>
    </message>
    <message>
        <source>Read it without --output.</source>
        <translation>Lesen Sie es ohne --output.</translation>
    </message>
    <message>
        <source>The folder has no dose (RTDOSE) that can be read as a volume.</source>
        <translation>Der Ordner enthält keine Dosis (RTDOSE), die als Volumen gelesen werden kann.</translation>
    </message>
    <message>
        <source>Put the dose of the plan into the folder.</source>
        <translation>Legen Sie die Dosis des Plans in den Ordner.</translation>
    </message>
    <message>
        <source>The series is no dose.</source>
        <translation>Die Serie ist keine Dosis.</translation>
    </message>
    <message>
        <source>Choose one of the modality RTDOSE in the list of macula info.</source>
        <translation>Wählen Sie eine der Modalität RTDOSE aus der Liste von macula info.</translation>
    </message>
    <message>
        <source>No dose of the folder lies in the coordinate system (frame of reference) of the volume.</source>
        <translation>Keine Dosis des Ordners liegt im Koordinatensystem (Frame of Reference) des Volumens.</translation>
    </message>
    <message>
        <source>Choose the images that the treatment was planned on.</source>
        <translation>Wählen Sie die Bilder, auf denen die Behandlung geplant wurde.</translation>
    </message>
    <message>
        <source>{} doses lie on the volume. The figures are of one of them; --dose chooses another.</source>
        <translation>Auf dem Volumen liegen {} Dosen. Die Zahlen gelten für eine davon; --dose wählt eine andere.</translation>
    </message>
    <message>
        <source>No images lie in the coordinate system of the dose: regions are drawn on its grid.</source>
        <translation>Im Koordinatensystem der Dosis liegen keine Bilder: Die Regionen werden auf ihr Gitter gezeichnet.</translation>
    </message>
    <message>
        <source>The dose lies in another coordinate system (frame of reference) than the volume.</source>
        <translation>Die Dosis liegt in einem anderen Koordinatensystem (Frame of Reference) als das Volumen.</translation>
    </message>
    <message>
        <source>There is no structure set or segmentation of this volume.</source>
        <translation>Zu diesem Volumen gibt es keinen Struktursatz und keine Segmentierung.</translation>
    </message>
    <message>
        <source>Put the structure set (RTSTRUCT) of the plan into the folder.</source>
        <translation>Legen Sie den Struktursatz (RTSTRUCT) des Plans in den Ordner.</translation>
    </message>
    <message>
        <source>Computing the dose in {} regions</source>
        <translation>Die Dosis in {} Regionen wird berechnet</translation>
    </message>
    <message>
        <source>{} regions lie partly or wholly outside the dose: figures are of the part inside.</source>
        <translation>{} Regionen liegen teilweise oder ganz außerhalb der Dosis: Die Zahlen gelten für den Teil innerhalb.</translation>
    </message>
    <message>
        <source>The voxels of {} regions were divided, because they are few, or larger than those of the dose.</source>
        <translation>Die Voxel von {} Regionen wurden unterteilt, weil es wenige sind oder sie größer sind als die der Dosis.</translation>
    </message>
    <message>
        <source>No prescription is known: percentages are of the highest dose, {:.4g} {}.</source>
        <translation>Eine Verschreibung ist nicht bekannt: Prozente beziehen sich auf die höchste Dosis, {:.4g} {}.</translation>
    </message>
    <message>
        <source>compute the dose in regions</source>
        <translation>die Dosis in Regionen berechnen</translation>
    </message>
    <message>
        <source>Dose of a whole plan</source>
        <translation>Dosis eines ganzen Plans</translation>
    </message>
    <message>
        <source>Dose of several plans</source>
        <translation>Dosis mehrerer Pläne</translation>
    </message>
    <message>
        <source>Dose of an overview of plans</source>
        <translation>Dosis einer Übersicht von Plänen</translation>
    </message>
    <message>
        <source>Dose of a fraction</source>
        <translation>Dosis einer Fraktion</translation>
    </message>
    <message>
        <source>Dose of a beam</source>
        <translation>Dosis eines Feldes</translation>
    </message>
    <message>
        <source>Dose of a source</source>
        <translation>Dosis einer Quelle</translation>
    </message>
    <message>
        <source>Dose of a part of a beam</source>
        <translation>Dosis eines Teils eines Feldes</translation>
    </message>
    <message>
        <source>Dose, and nothing says of what</source>
        <translation>Dosis; nichts sagt, wovon</translation>
    </message>
    <message>
        <source>{:.4g} Gy prescribed in {} fractions</source>
        <translation>{:.4g} Gy verschrieben in {} Fraktionen</translation>
    </message>
    <message>
        <source>{:.4g} Gy prescribed</source>
        <translation>{:.4g} Gy verschrieben</translation>
    </message>
    <message>
        <source>The values of the dose are relative to a reference, and not in Gy.</source>
        <translation>Die Werte der Dosis sind relativ zu einem Bezug und nicht in Gy.</translation>
    </message>
    <message>
        <source>It is a difference between doses, and no dose.</source>
        <translation>Sie ist ein Unterschied zwischen Dosen und keine Dosis.</translation>
    </message>
    <message>
        <source>It is an effective dose: the planning system weighted the physical one.</source>
        <translation>Sie ist eine effektive Dosis: Das Planungssystem hat die physikalische gewichtet.</translation>
    </message>
    <message>
        <source>It is not the dose of one whole plan: no prescription applies to it.</source>
        <translation>Sie ist nicht die Dosis eines einzelnen ganzen Plans: Keine Verschreibung gilt für sie.</translation>
    </message>
    <message>
        <source>It does not name one plan: the prescription is not known.</source>
        <translation>Sie nennt nicht genau einen Plan: Die Verschreibung ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Its plan is not in the folder: the prescription is not known.</source>
        <translation>Ihr Plan liegt nicht im Ordner: Die Verschreibung ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Its plan prescribes no dose to a target.</source>
        <translation>Ihr Plan verschreibt keinem Zielvolumen eine Dosis.</translation>
    </message>
    <message>
        <source>Its plan has {} prescriptions, from {:.4g} to {:.4g} Gy: percentages are of the highest.</source>
        <translation>Ihr Plan hat {} Verschreibungen, von {:.4g} bis {:.4g} Gy: Prozente beziehen sich auf die höchste.</translation>
    </message>
    <message>
        <source>Computing the dose in regions was cancelled.</source>
        <translation>Das Berechnen der Dosis in Regionen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>compute the dose in a region</source>
        <translation>die Dosis in einer Region berechnen</translation>
    </message>
    <message>
        <source>Dose on series {}</source>
        <translation>Dosis auf Serie {}</translation>
    </message>
    <message>
        <source>Dose on images of this folder</source>
        <translation>Dosis auf Bildern dieses Ordners</translation>
    </message>
    <message>
        <source>The archive is cut off or damaged: what follows its first {} files is lost.</source>
        <translation>Das Archiv ist abgeschnitten oder beschädigt: Was nach seinen ersten {} Dateien kommt, ist verloren.</translation>
    </message>
    <message>
        <source>Get the archive again; images may be missing.</source>
        <translation>Das Archiv neu beschaffen; es können Bilder fehlen.</translation>
    </message>
    <message>
        <source>Files in the archive that are encrypted, and were left out: {}.</source>
        <translation>Dateien im Archiv, die verschlüsselt sind und ausgelassen wurden: {}.</translation>
    </message>
    <message>
        <source>Unpack it with another program, which asks for the password, and open the folder.</source>
        <translation>Mit einem anderen Programm entpacken, das nach dem Passwort fragt, und den Ordner öffnen.</translation>
    </message>
    <message>
        <source>Files in the archive that are damaged, or packed in a way that Macula does not know, and were left out: {}.</source>
        <translation>Dateien im Archiv, die beschädigt oder auf eine Macula unbekannte Art gepackt sind und ausgelassen wurden: {}.</translation>
    </message>
    <message>
        <source>Links and devices in the archive, which were left out: {}.</source>
        <translation>Verweise und Geräte im Archiv, die ausgelassen wurden: {}.</translation>
    </message>
    <message>
        <source>Files whose names lead out of the archive, and which were unpacked like the others: {}.</source>
        <translation>Dateien, deren Namen aus dem Archiv hinausführen und die wie die anderen entpackt wurden: {}.</translation>
    </message>
    <message>
        <source>The archive was unpacked. {}</source>
        <translation>Das Archiv wurde entpackt. {}</translation>
    </message>
    <message>
        <source>outside the regions of ultrasound</source>
        <translation>außerhalb der Ultraschallbereiche</translation>
    </message>
    <message>
        <source>across two regions of ultrasound</source>
        <translation>über zwei Ultraschallbereiche hinweg</translation>
    </message>
    <message>
        <source>at the detector</source>
        <translation>am Detektor</translation>
    </message>
    <message>
        <source>at the object by magnification {:.3g}</source>
        <translation>am Objekt, nach Vergrößerung {:.3g}</translation>
    </message>
    <message>
        <source>the size of the film alone is known</source>
        <translation>nur die Größe des Films ist bekannt</translation>
    </message>
    <message>
        <source>calibrated by geometry</source>
        <translation>kalibriert nach der Geometrie</translation>
    </message>
    <message>
        <source>calibrated by a fiducial</source>
        <translation>kalibriert an einem Referenzobjekt</translation>
    </message>
    <message>
        <source>rows and columns have different units here</source>
        <translation>Zeilen und Spalten haben hier verschiedene Einheiten</translation>
    </message>
    <message>
        <source>Its window is of other values than those of the image, and is not shown.</source>
        <translation>Sein Fenster gilt für andere Werte als die des Bildes und wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>Its window is a table of values (VOI LUT) that cannot be read.</source>
        <translation>Sein Fenster ist eine Wertetabelle (VOI LUT), die sich nicht lesen lässt.</translation>
    </message>
    <message>
        <source>It turns its images by another angle than quarters, which is not shown.</source>
        <translation>Er dreht seine Bilder um einen anderen Winkel als um Vierteldrehungen; das wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>It asks for a size on the screen, which is not shown: its part of the image fits the pane.</source>
        <translation>Er verlangt eine Größe auf dem Bildschirm, die nicht gezeigt wird: Sein Teil des Bildes füllt das Feld.</translation>
    </message>
    <message>
        <source>Unpack it with another program if you trust it, and open the folder.</source>
        <translation>Wer dem Archiv traut, entpackt es mit einem anderen Programm und öffnet den Ordner.</translation>
    </message>
    <message>
        <source>The disk has too little space to unpack the archive, and nothing of it was kept.</source>
        <translation>Auf der Platte ist zu wenig Platz, um das Archiv zu entpacken; nichts davon wurde behalten.</translation>
    </message>
    <message>
        <source>Free space there, or choose a data folder on another disk: XDG_DATA_HOME names it.</source>
        <translation>Dort Platz schaffen oder einen Datenordner auf einer anderen Platte wählen: XDG_DATA_HOME nennt ihn.</translation>
    </message>
    <message>
        <source>The archive holds more than {} files, which Macula does not unpack.</source>
        <translation>Das Archiv enthält mehr als {} Dateien; so viele entpackt Macula nicht.</translation>
    </message>
    <message>
        <source>The archive unpacks to more than {} GB, or one file in it to more than {} GB, which Macula does not unpack.</source>
        <translation>Entpackt wäre das Archiv größer als {} GB oder eine Datei darin größer als {} GB; so viel entpackt Macula nicht.</translation>
    </message>
    <message>
        <source>The archive unpacks to hundreds of times its size, as files do that are made to fill disks. Nothing of it was kept.</source>
        <translation>Entpackt wäre das Archiv mehrere hundert Mal so groß, wie bei Dateien, die Platten füllen sollen. Nichts davon wurde behalten.</translation>
    </message>
    <message>
        <source>Unpacking was cancelled.</source>
        <translation>Das Entpacken wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Unpacking the archive</source>
        <translation>Das Archiv wird entpackt</translation>
    </message>
    <message>
        <source>The copy of the archive cannot be written.</source>
        <translation>Die Kopie des Archivs kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Check free space, and the permissions of the data folder.</source>
        <translation>Freien Platz und die Rechte des Datenordners prüfen.</translation>
    </message>
    <message>
        <source>The file is no archive that Macula can open, whatever its name says: it opens ZIP, tar and ISO 9660 files.</source>
        <translation>Die Datei ist kein Archiv, das Macula öffnen kann, was auch immer ihr Name sagt: Macula öffnet ZIP-, tar- und ISO-9660-Dateien.</translation>
    </message>
    <message>
        <source>Unpack it with another program, and open the folder. If that fails too, get the file again.</source>
        <translation>Mit einem anderen Programm entpacken und den Ordner öffnen. Misslingt auch das, die Datei neu beschaffen.</translation>
    </message>
    <message>
        <source>The archive is encrypted, and cannot be opened without its password.</source>
        <translation>Das Archiv ist verschlüsselt und lässt sich ohne sein Passwort nicht öffnen.</translation>
    </message>
    <message>
        <source>No file in the archive can be read: it is damaged or incomplete.</source>
        <translation>Keine Datei im Archiv ist lesbar: Es ist beschädigt oder unvollständig.</translation>
    </message>
    <message>
        <source>Get the archive again.</source>
        <translation>Das Archiv neu beschaffen.</translation>
    </message>
    <message>
        <source>There is no file in the archive.</source>
        <translation>Im Archiv ist keine Datei.</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>Eine andere Datei wählen.</translation>
    </message>
    <message>
        <source>unpack this archive</source>
        <translation>dieses Archiv zu entpacken</translation>
    </message>
    <message>
        <source>There is no room for a file that another program can open.</source>
        <translation>Für eine Datei, die ein anderes Programm öffnen kann, ist kein Platz.</translation>
    </message>
    <message>
        <source>Save the file to a folder of yours instead.</source>
        <translation>Speichern Sie die Datei stattdessen in einem eigenen Ordner.</translation>
    </message>
    <message>
        <source>Memory is not enough for all phases at once.</source>
        <translation>Der Speicher reicht nicht für alle Phasen zugleich.</translation>
    </message>
    <message>
        <source>Open each phase by itself.</source>
        <translation>Öffnen Sie jede Phase für sich.</translation>
    </message>
    <message>
        <source>read the presentation state</source>
        <translation>den Presentation State zu lesen</translation>
    </message>
    <message>
        <source>Nothing is stored.</source>
        <translation>Es wird nichts gespeichert.</translation>
    </message>
    <message>
        <source>write the volume for the program</source>
        <translation>das Volumen für das Programm zu schreiben</translation>
    </message>
    <message>
        <source>This is no image, and is not shown in 3D: {kind}.</source>
        <translation>Das ist kein Bild und wird nicht in 3D gezeigt: {kind}.</translation>
    </message>
    <message>
        <source>Panel: measurements</source>
        <translation>Feld: Messungen</translation>
    </message>
    <message>
        <source>Drag a ring on the cross-hair, Ctrl + Left and Right on slices</source>
        <translation>Einen Ring am Fadenkreuz ziehen, Strg + Links und Rechts auf Schichten</translation>
    </message>
    <message>
        <source>D, G, E, C, W, O, Delete, Enter on images</source>
        <translation>D, G, E, C, W, O, Entf, Eingabe auf Bildern</translation>
    </message>
    <message>
        <source>Measure: distance, angle, ellipse, Cobb angle; window; overlays; remove, label</source>
        <translation>Messen: Strecke, Winkel, Ellipse, Cobb-Winkel; Fenster; Overlays; entfernen, bezeichnen</translation>
    </message>
    <message>
        <source>There can be at most {} segments of your own.</source>
        <translation>Es kann höchstens {} eigene Segmente geben.</translation>
    </message>
    <message>
        <source>Delete some of them first.</source>
        <translation>Löschen Sie zuerst einige davon.</translation>
    </message>
    <message>
        <source>Reading headers was cancelled.</source>
        <translation>Das Lesen der Kopfdaten wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Save a hanging protocol again.</source>
        <translation>Speichern Sie ein Hängeprotokoll noch einmal.</translation>
    </message>
    <message>
        <source>These are no hanging protocols.</source>
        <translation>Das sind keine Hängeprotokolle.</translation>
    </message>
    <message>
        <source>Hanging protocol {} lacks a value, or has one of another kind.</source>
        <translation>Hängeprotokoll {} fehlt ein Wert, oder einer ist von anderer Art.</translation>
    </message>
    <message>
        <source>Hanging protocol {} has a value out of range.</source>
        <translation>Hängeprotokoll {} hat einen Wert außerhalb der Grenzen.</translation>
    </message>
    <message>
        <source>A hanging protocol has a name of up to {} bytes.</source>
        <translation>Ein Hängeprotokoll hat einen Namen von höchstens {} Bytes.</translation>
    </message>
    <message>
        <source>Give it a shorter name.</source>
        <translation>Geben Sie ihm einen kürzeren Namen.</translation>
    </message>
    <message>
        <source>There are {} hanging protocols already.</source>
        <translation>Es gibt schon {} Hängeprotokolle.</translation>
    </message>
    <message>
        <source>Mammograms above the prior</source>
        <translation>Mammographien über der Voraufnahme</translation>
    </message>
    <message>
        <source>Four mammograms</source>
        <translation>Vier Mammographien</translation>
    </message>
    <message>
        <source>Mammograms of both sides</source>
        <translation>Mammographien beider Seiten</translation>
    </message>
    <message>
        <source>X-ray beside the prior</source>
        <translation>Röntgenbild neben der Voraufnahme</translation>
    </message>
    <message>
        <source>Two X-rays</source>
        <translation>Zwei Röntgenbilder</translation>
    </message>
    <message>
        <source>Slices with three priors</source>
        <translation>Schichten mit drei Voruntersuchungen</translation>
    </message>
    <message>
        <source>Slices with two priors</source>
        <translation>Schichten mit zwei Voruntersuchungen</translation>
    </message>
    <message>
        <source>Slices beside the prior</source>
        <translation>Schichten neben der Voruntersuchung</translation>
    </message>
    <message>
        <source>Two series of slices</source>
        <translation>Zwei Serien von Schichten</translation>
    </message>
    <message>
        <source>The mark could not be kept.</source>
        <translation>Die Markierung konnte nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Is the disk full?</source>
        <translation>Ist die Platte voll?</translation>
    </message>
    <message>
        <source>B, L on images</source>
        <translation>B, L auf Bildern</translation>
    </message>
    <message>
        <source>The chosen box alone, or all of them; boxes scroll together, or not</source>
        <translation>Das gewählte Feld allein oder alle; Felder blättern zusammen oder nicht</translation>
    </message>
    <message>
        <source>The slices as they were acquired, in boxes, with priors beside them</source>
        <translation>Die Schichten wie aufgenommen, in Feldern, mit Voruntersuchungen daneben</translation>
    </message>
    <message>
        <source>A label map has the number of a segment in each voxel, and 0 where there is none.</source>
        <translation>Eine Label-Map hat in jedem Voxel die Nummer eines Segments, und 0, wo keines ist.</translation>
    </message>
    <message>
        <source>It has values that are no numbers of segments: whole ones from 0 to 65535.</source>
        <translation>Sie hat Werte, die keine Nummern von Segmenten sind: ganze Zahlen von 0 bis 65535.</translation>
    </message>
    <message>
        <source>It has more than {} segments.</source>
        <translation>Sie hat mehr als {} Segmente.</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>{} difference</source>
        <translation>{} Differenz</translation>
    </message>
    <message>
        <source>A plane of that size or place cannot be written as DICOM.</source>
        <translation>Eine Ebene dieser Größe oder Lage lässt sich nicht als DICOM schreiben.</translation>
    </message>
    <message>
        <source>The images of this series have no identifiers or no frame of reference, and what is written could not refer to them.</source>
        <translation>Die Bilder dieser Serie haben keine Kennungen oder kein Koordinatensystem (Frame of Reference); das Geschriebene könnte sich nicht auf sie beziehen.</translation>
    </message>
    <message>
        <source>Write the planes without patient and study.</source>
        <translation>Schreiben Sie die Ebenen ohne Patient und Studie.</translation>
    </message>
    <message>
        <source>Choose a file with a segmentation, or open this one as a volume.</source>
        <translation>Wählen Sie eine Datei mit einer Segmentierung, oder öffnen Sie diese als Volumen.</translation>
    </message>
    <message>
        <source>The file holds {} volumes, and is no label map of one.</source>
        <translation>Die Datei enthält {} Volumen und ist keine Label-Map von einem.</translation>
    </message>
    <message>
        <source>The file has more than {} layers of segments.</source>
        <translation>Die Datei hat mehr als {} Schichten von Segmenten.</translation>
    </message>
    <message>
        <source>It has no segment: all of its voxels are 0.</source>
        <translation>Sie hat kein Segment: Alle ihre Voxel sind 0.</translation>
    </message>
    <message>
        <source>read this label map</source>
        <translation>diese Label-Map lesen</translation>
    </message>
    <message>
        <source>The image has several values in each voxel, such as colours or the components of a vector, which are no times; a volume needs one value.</source>
        <translation>Das Bild hat mehrere Werte in jedem Voxel, etwa Farben oder die Komponenten eines Vektors, die keine Zeiten sind; ein Volumen braucht einen Wert.</translation>
    </message>
    <message>
        <source>Write each of them to a file of its own.</source>
        <translation>Schreiben Sie jeden davon in eine eigene Datei.</translation>
    </message>
    <message>
        <source>The file holds more volumes than Macula reads: {}.</source>
        <translation>Die Datei enthält mehr Volumen, als Macula liest: {}.</translation>
    </message>
    <message>
        <source>The file holds {} volumes along an axis in {}, which is no time; this is number {}.</source>
        <translation>Die Datei enthält {} Volumen entlang einer Achse in {}, die keine Zeit ist; dies ist Nummer {}.</translation>
    </message>
    <message>
        <source>Nothing says what to do with the segments of the label map.</source>
        <translation>Nichts sagt, was mit den Segmenten der Label-Map geschehen soll.</translation>
    </message>
    <message>
        <source>Add --segments, such as --segments colour:&quot;Label 1&quot;.</source>
        <translation>Geben Sie --segments an, etwa --segments colour:&quot;Label 1&quot;.</translation>
    </message>
    <message>
        <source>Leave --segments out, or give a file with segments by --label-map.</source>
        <translation>Lassen Sie --segments weg, oder geben Sie mit --label-map eine Datei mit Segmenten an.</translation>
    </message>
    <message>
        <source>The packed PLY file lacks what its splats are packed by.</source>
        <translation>Der gepackten PLY-Datei fehlt, wonach ihre Splats gepackt sind.</translation>
    </message>
    <message>
        <source>The packed PLY file has coefficients of colour that fit no degree.</source>
        <translation>Die gepackte PLY-Datei hat Farbkoeffizienten, die zu keinem Grad passen.</translation>
    </message>
    <message>
        <source>Lesions that were not measured at the baseline, and are in no sum: {}. A new lesion is progressive disease whatever its size.</source>
        <translation>Läsionen, die in der Ausgangsuntersuchung nicht gemessen wurden und in keiner Summe sind: {}. Eine neue Läsion ist ein Progress, wie groß sie auch ist.</translation>
    </message>
    <message>
        <source>A label stands at several measurements of one study: the longest counts.</source>
        <translation>Eine Beschriftung steht an mehreren Messungen einer Untersuchung: Die längste zählt.</translation>
    </message>
    <message>
        <source>A lesion is called a lymph node in one study and not in another: it counts as one in all.</source>
        <translation>Eine Läsion heißt in einer Untersuchung Lymphknoten und in einer anderen nicht: Sie zählt in allen als einer.</translation>
    </message>
    <message>
        <source>A lymph node was measured with a distance, which has no short axis: it counts as not measured.</source>
        <translation>Ein Lymphknoten wurde mit einer Strecke gemessen, die keine kurze Achse hat: Er zählt als nicht gemessen.</translation>
    </message>
    <message>
        <source>RECIST 1.1 calls lesions below 10 mm, and lymph nodes below 15 mm, not measurable: at the baseline these are {}.</source>
        <translation>RECIST 1.1 nennt Läsionen unter 10 mm und Lymphknoten unter 15 mm nicht messbar: In der Ausgangsuntersuchung sind das {}.</translation>
    </message>
    <message>
        <source>RECIST 1.1 follows at most five lesions, two in an organ; here are {}.</source>
        <translation>RECIST 1.1 verfolgt höchstens fünf Läsionen, zwei je Organ; hier sind es {}.</translation>
    </message>
    <message>
        <source>Shapes that Macula does not measure, and that were left out: {}.</source>
        <translation>Formen, die Macula nicht misst und die weggelassen wurden: {}.</translation>
    </message>
    <message>
        <source>The report draws nothing that Macula measures.</source>
        <translation>Der Bericht zeichnet nichts, was Macula misst.</translation>
    </message>
    <message>
        <source>Choose other distances, or another number of planes.</source>
        <translation>Wählen Sie andere Abstände oder eine andere Zahl von Ebenen.</translation>
    </message>
    <message>
        <source>These numbers make no planes.</source>
        <translation>Diese Zahlen ergeben keine Ebenen.</translation>
    </message>
    <message>
        <source>These are more than {} planes.</source>
        <translation>Das sind mehr als {} Ebenen.</translation>
    </message>
    <message>
        <source>A plane would have more than {} pixels a side.</source>
        <translation>Eine Ebene hätte mehr als {} Pixel an einer Seite.</translation>
    </message>
    <message>
        <source>Values are rounded to steps of {:.3g}.</source>
        <translation>Werte sind auf Stufen von {:.3g} gerundet.</translation>
    </message>
    <message>
        <source>Pixels are larger than voxels: {:.3g} mm.</source>
        <translation>Pixel sind größer als Voxel: {:.3g} mm.</translation>
    </message>
    <message>
        <source>Writing {} planes</source>
        <translation>{} Ebenen werden geschrieben</translation>
    </message>
    <message>
        <source>None of these planes meets the volume.</source>
        <translation>Keine dieser Ebenen trifft das Volumen.</translation>
    </message>
    <message>
        <source>Choose other distances.</source>
        <translation>Wählen Sie andere Abstände.</translation>
    </message>
    <message>
        <source>There is not enough memory for these planes.</source>
        <translation>Der Speicher reicht nicht für diese Ebenen.</translation>
    </message>
    <message>
        <source>Choose fewer, or close other programs.</source>
        <translation>Wählen Sie weniger, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>write the planes</source>
        <translation>die Ebenen schreiben</translation>
    </message>
    <message>
        <source>A report of measurements has no place for arrows and their words: of {} measurements, it leaves out {}.</source>
        <translation>Ein Bericht von Messungen hat keinen Platz für Pfeile und ihre Worte: Von {} Messungen lässt er {} weg.</translation>
    </message>
    <message>
        <source>No ellipse or outline is drawn.</source>
        <translation>Es ist keine Ellipse und kein Umriss gezeichnet.</translation>
    </message>
    <message>
        <source>&quot;distance&quot;, &quot;angle&quot;, &quot;ellipse&quot;, &quot;bidirectional&quot;, &quot;cobb angle&quot;, &quot;arrow&quot;, &quot;outline&quot; or &quot;line&quot;</source>
        <translation>&quot;distance&quot;, &quot;angle&quot;, &quot;ellipse&quot;, &quot;bidirectional&quot;, &quot;cobb angle&quot;, &quot;arrow&quot;, &quot;outline&quot; oder &quot;line&quot;</translation>
    </message>
    <message>
        <source>The two phases do not lie on one grid in one unit: there is no difference of their values.</source>
        <translation>Die beiden Phasen liegen nicht auf einem Gitter in einer Einheit: Es gibt keine Differenz ihrer Werte.</translation>
    </message>
    <message>
        <source>Choose another phase.</source>
        <translation>Wählen Sie eine andere Phase.</translation>
    </message>
    <message>
        <source>There is not enough memory for the difference of two phases.</source>
        <translation>Der Speicher reicht nicht für die Differenz zweier Phasen.</translation>
    </message>
    <message>
        <source>Rejected images: {}</source>
        <translation>Zurückgewiesene Bilder: {}</translation>
    </message>
    <message>
        <source>★ 1 key image</source>
        <translation>★ 1 Schlüsselbild</translation>
    </message>
    <message>
        <source>★ {} key images</source>
        <translation>★ {} Schlüsselbilder</translation>
    </message>
    <message>
        <source>Reading the key images was cancelled.</source>
        <translation>Das Lesen der Schlüsselbilder wurde abgebrochen.</translation>
    </message>
    <message>
        <source>read the key images</source>
        <translation>die Schlüsselbilder lesen</translation>
    </message>
    <message>
        <source>The file holds {} volumes; Macula can choose from {} at most, and shows the first alone.</source>
        <translation>Die Datei enthält {} Volumen; Macula kann aus höchstens {} wählen und zeigt nur das erste.</translation>
    </message>
    <message>
        <source>The file is another one by now.</source>
        <translation>Die Datei ist inzwischen eine andere.</translation>
    </message>
    <message>
        <source>Open it again.</source>
        <translation>Öffnen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>the file does not say when</source>
        <translation>die Datei sagt nicht, wann</translation>
    </message>
    <message>
        <source>time {:.6g} s</source>
        <translation>Zeit {:.6g} s</translation>
    </message>
    <message>
        <source>time {:.6g} ms</source>
        <translation>Zeit {:.6g} ms</translation>
    </message>
    <message>
        <source>at {:.6g}, in a unit that the file does not name</source>
        <translation>bei {:.6g}, in einer Einheit, die die Datei nicht nennt</translation>
    </message>
    <message>
        <source>at {:.6g} {}, which is no time</source>
        <translation>bei {:.6g} {}, was keine Zeit ist</translation>
    </message>
    <message>
        <source>The file names no patient and no frame of reference: it was taken to be of this patient, and to lie in the coordinate system of this volume.</source>
        <translation>Die Datei nennt weder Patient noch Koordinatensystem (Frame of Reference): Angenommen wurde, dass sie von diesem Patienten ist und im Koordinatensystem dieses Volumens liegt.</translation>
    </message>
    <message>
        <source>The file has the numbers of segments, not their names.</source>
        <translation>Die Datei hat die Nummern der Segmente, nicht ihre Namen.</translation>
    </message>
    <message>
        <source>Placing the segments</source>
        <translation>Segmente werden eingeordnet</translation>
    </message>
    <message>
        <source>No voxel of this segmentation lies in the volume that is open.</source>
        <translation>Kein Voxel dieser Segmentierung liegt im geöffneten Volumen.</translation>
    </message>
    <message>
        <source>Open the volume that it was drawn on first.</source>
        <translation>Öffnen Sie zuerst das Volumen, auf dem sie gezeichnet wurde.</translation>
    </message>
    <message>
        <source>open this segmentation</source>
        <translation>diese Segmentierung öffnen</translation>
    </message>
    <message>
        <source>Next key image of the folder</source>
        <translation>Nächstes Schlüsselbild des Ordners</translation>
    </message>
    <message>
        <source>C, W, Z, M, D, Shift+D, G, Shift+G, E, Shift+E, Shift+Y, H, V, U, Y</source>
        <translation>C, W, Z, M, D, Umschalt+D, G, Umschalt+G, E, Umschalt+E, Umschalt+Y, H, V, U, Y</translation>
    </message>
    <message>
        <source>Left button on slices: cross-hair, window, zoom, move, distance, lesion, angle, Cobb angle, ellipse, outline, line, arrow, probe, segment, curve</source>
        <translation>Linke Taste auf Schichten: Fadenkreuz, Fenster, Zoom, Verschieben, Strecke, Läsion, Winkel, Cobb-Winkel, Ellipse, Umriss, Linie, Pfeil, Sonde, Segment, Kurve</translation>
    </message>
    <message>
        <source>Lesions that were measured before the baseline and not at it are in no sum: {}.</source>
        <translation>Läsionen, die vor dem Ausgangsbefund gemessen wurden und nicht bei ihm, sind in keiner Summe: {}.</translation>
    </message>
    <message>
        <source>It has {} numbers and hardly a voxel that is 0: it seems to be an image.</source>
        <translation>Sie hat {} Zahlen und kaum einen Bildpunkt mit 0: Sie scheint ein Bild zu sein.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ArchiveController</name>
    <message>
        <source>Fetching was cancelled. What came is kept; opening the study again goes on from there.</source>
        <translation>Das Abrufen wurde abgebrochen. Was gekommen ist, bleibt erhalten; wird die Studie noch einmal geöffnet, geht es dort weiter.</translation>
    </message>
    <message>
        <source>Open from an &amp;Archive…</source>
        <translation>Aus einem A&amp;rchiv öffnen…</translation>
    </message>
    <message>
        <source>Search a PACS, and fetch a study from it</source>
        <translation>Ein PACS durchsuchen und eine Studie abrufen</translation>
    </message>
    <message numerus="yes">
        <source>%n images fetched</source>
        <translation>
            <numerusform>%n Bild abgerufen</numerusform>
            <numerusform>%n Bilder abgerufen</numerusform>
        </translation>
    </message>
    <message>
        <source>Another study was opened meanwhile. Open shows this one.</source>
        <translation>Inzwischen wurde eine andere Studie geöffnet. „Öffnen“ zeigt diese.</translation>
    </message>
    <message>
        <source>Images of this study are still arriving from the archive.</source>
        <translation>Bilder dieser Studie kommen noch aus dem Archiv.</translation>
    </message>
    <message>
        <source>This study is not known to be complete: images that the archive has may be missing. Fetch it again.</source>
        <translation>Es ist nicht bekannt, ob diese Studie vollständig ist: Bilder, die das Archiv hat, können fehlen. Rufen Sie sie noch einmal ab.</translation>
    </message>
    <message>
        <source>The search was stopped.</source>
        <translation>Die Suche wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Somebody sent this study without saying how many images it has: some may be missing.</source>
        <translation>Beim Senden dieser Studie wurde nicht angegeben, wie viele Bilder sie hat: einige können fehlen.</translation>
    </message>
    <message>
        <source>Another study was opened meanwhile. Beside shows this one next to it.</source>
        <translation>Inzwischen wurde eine andere Studie geöffnet. Daneben zeigt diese neben ihr.</translation>
    </message>
    <message>
        <source>Study Is &amp;Read</source>
        <translation>Untersuchung ist &amp;gelesen</translation>
    </message>
    <message>
        <source>Mark the open study as read, in the lists of studies</source>
        <translation>Die offene Untersuchung in den Listen als gelesen markieren</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ArchivePanel</name>
    <message>
        <source>Set up…</source>
        <translation>Einrichten…</translation>
    </message>
    <message>
        <source>Set up an archive, try it, or remove it</source>
        <translation>Ein Archiv einrichten, prüfen oder entfernen</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Name, family name first; * stands for what is not known</source>
        <translation>Name, Nachname zuerst; * steht für das, was nicht bekannt ist</translation>
    </message>
    <message>
        <source>Patient ID</source>
        <translation>Patienten-ID</translation>
    </message>
    <message>
        <source>As the hospital writes it</source>
        <translation>Wie das Krankenhaus sie schreibt</translation>
    </message>
    <message>
        <source>Accession number</source>
        <translation>Accession-Nummer</translation>
    </message>
    <message>
        <source>Of the order</source>
        <translation>Die des Auftrags</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Of the study; * stands for what is not known</source>
        <translation>Die der Studie; * steht für das, was nicht bekannt ist</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Earliest day of the study, as 2026-11-30</source>
        <translation>Frühester Tag der Studie: 2026-11-30</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Latest day of the study</source>
        <translation>Spätester Tag der Studie</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Studies that hold images of this kind</source>
        <translation>Studien, die Bilder dieser Art enthalten</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>No archive has been set up yet. Set one up, or ask your administrator.</source>
        <translation>Es ist noch kein Archiv eingerichtet. Richten Sie eines ein, oder fragen Sie Ihre Systemverwaltung.</translation>
    </message>
    <message>
        <source>A day is written as 2026-11-30.</source>
        <translation>Ein Tag wird als 2026-11-30 geschrieben.</translation>
    </message>
    <message numerus="yes">
        <source>%n studies</source>
        <translation>
            <numerusform>%n Studie</numerusform>
            <numerusform>%n Studien</numerusform>
        </translation>
    </message>
    <message>
        <source>; there are more. Narrow the search.</source>
        <translation>; es gibt mehr. Grenzen Sie die Suche ein.</translation>
    </message>
    <message>
        <source>No study matches.</source>
        <translation>Keine Studie passt.</translation>
    </message>
    <message>
        <source>Ask the archive; Enter in a field does the same</source>
        <translation>Das Archiv fragen; die Eingabetaste in einem Feld tut dasselbe</translation>
    </message>
    <message>
        <source>Where to search</source>
        <translation>Wo gesucht wird</translation>
    </message>
    <message>
        <source>All archives (PACS) and this machine, or one of them</source>
        <translation>Alle Archive (PACS) und dieser Rechner, oder eines davon</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Studies that match</source>
        <translation>Gefundene Studien</translation>
    </message>
    <message>
        <source>Search Everywhere</source>
        <translation>Überall suchen</translation>
    </message>
    <message>
        <source>Search everywhere for studies of this patient</source>
        <translation>Überall nach Studien dieses Patienten suchen</translation>
    </message>
    <message>
        <source>Ask all archives, and this machine, for other studies of the patient</source>
        <translation>Alle Archive und diesen Rechner nach anderen Studien des Patienten fragen</translation>
    </message>
    <message>
        <source>Other studies of this patient</source>
        <translation>Andere Studien dieses Patienten</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>Dieser Rechner</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche läuft…</translation>
    </message>
    <message>
        <source>Stop Searching</source>
        <translation>Suche abbrechen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ArrivalBar</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open the study that arrived</source>
        <translation>Die angekommene Studie öffnen</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Close this message; the study stays where it is</source>
        <translation>Diese Meldung schließen; die Studie bleibt, wo sie ist</translation>
    </message>
    <message numerus="yes">
        <source>A new study arrived in %1: %2, %n images</source>
        <translation>
            <numerusform>Eine neue Studie ist in %1 angekommen: %2, %n Bild</numerusform>
            <numerusform>Eine neue Studie ist in %1 angekommen: %2, %n Bilder</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A new study arrived in a folder that is watched: %1, %n images</source>
        <translation>
            <numerusform>Eine neue Studie ist in einem überwachten Ordner angekommen: %1, %n Bild</numerusform>
            <numerusform>Eine neue Studie ist in einem überwachten Ordner angekommen: %1, %n Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>no patient name</source>
        <translation>kein Patientenname</translation>
    </message>
    <message numerus="yes">
        <source> %n more arrived.</source>
        <translation>
            <numerusform> %n weitere ist angekommen.</numerusform>
            <numerusform> %n weitere sind angekommen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A new study was sent by %1: %2, %n images</source>
        <translation>
            <numerusform>Eine neue Studie wurde von %1 gesendet: %2, %n Bild</numerusform>
            <numerusform>Eine neue Studie wurde von %1 gesendet: %2, %n Bilder</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::BackgroundMenu</name>
    <message>
        <source>Back&amp;ground</source>
        <translation>&amp;Hintergrund</translation>
    </message>
    <message>
        <source>&amp;Nearly Black</source>
        <translation>&amp;Fast schwarz</translation>
    </message>
    <message>
        <source>As when nobody has chosen; saved pictures are black then</source>
        <translation>Wie wenn niemand gewählt hat; gespeicherte Bilder sind dann schwarz</translation>
    </message>
    <message>
        <source>&amp;Black</source>
        <translation>&amp;Schwarz</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Grau</translation>
    </message>
    <message>
        <source>&amp;White</source>
        <translation>&amp;Weiß</translation>
    </message>
    <message>
        <source>&amp;Other Colour…</source>
        <translation>&amp;Andere Farbe…</translation>
    </message>
    <message>
        <source>Of what lies behind the patient in the 3D picture, and in pictures saved of it</source>
        <translation>Was im 3D-Bild hinter dem Patienten liegt, auch in Bildern, die davon gespeichert werden</translation>
    </message>
    <message>
        <source>Colour of the background</source>
        <translation>Farbe des Hintergrunds</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
</context>
<context>
    <name>macula::viewer::BrowserController</name>
    <message>
        <source>&amp;Find a Study…</source>
        <translation>Studie &amp;suchen…</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ClipEditing</name>
    <message>
        <source>Depth of the cut</source>
        <translation>Tiefe des Schnitts</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>The clip has six planes and no more.</source>
        <translation>Der Beschnitt hat sechs Ebenen und nicht mehr.</translation>
    </message>
    <message>
        <source>Remove one of them first, or begin without a clip.</source>
        <translation>Entfernen Sie zuerst eine davon, oder beginnen Sie ohne Beschnitt.</translation>
    </message>
    <message>
        <source>Cut from the eye</source>
        <translation>Schnitt vom Auge aus</translation>
    </message>
    <message>
        <source>There are %1 cuts with the scissors, and no more are possible.</source>
        <translation>Es gibt %1 Schnitte mit der Schere, und mehr sind nicht möglich.</translation>
    </message>
    <message>
        <source>Undo one of them first.</source>
        <translation>Machen Sie zuerst einen davon rückgängig.</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Remove cuts</source>
        <translation>Schnitte entfernen</translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation>Keine Studie ist offen.</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ClipPanel</name>
    <message>
        <source>Turn inside out</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Shows what the clip removes, and removes what it shows</source>
        <translation>Zeigt, was der Beschnitt entfernt, und entfernt, was er zeigt</translation>
    </message>
    <message>
        <source>Undo all: no clip</source>
        <translation>Alles zurück: kein Beschnitt</translation>
    </message>
    <message>
        <source>Shows all of the volume again</source>
        <translation>Zeigt wieder das ganze Volumen</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>No clip</source>
        <translation>Kein Beschnitt</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigener</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Where the cross-hair is, in mm of the patient (LPS)</source>
        <translation>Wo das Fadenkreuz ist, in mm des Patienten (LPS)</translation>
    </message>
    <message>
        <source>At the cross-hair</source>
        <translation>Am Fadenkreuz</translation>
    </message>
    <message>
        <source>Thickness of the slab</source>
        <translation>Dicke des Slabs</translation>
    </message>
    <message>
        <source>How thick the slab is, in mm</source>
        <translation>Wie dick der Slab ist, in mm</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronar</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Direction of the slab</source>
        <translation>Richtung des Slabs</translation>
    </message>
    <message>
        <source>Along which slices the slab lies</source>
        <translation>Entlang welcher Schichten der Slab liegt</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Which of the eight parts around the cross-hair is meant</source>
        <translation>Welcher der acht Teile um das Fadenkreuz gemeint ist</translation>
    </message>
    <message>
        <source>Removes that corner; it takes the place of another corner</source>
        <translation>Entfernt diese Ecke; sie ersetzt eine andere Ecke</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Slab</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Which part of the volume is shown</source>
        <translation>Welcher Teil des Volumens gezeigt wird</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>Oblique planes that cut: %1.</source>
        <translation>Schräge Ebenen, die schneiden: %1.</translation>
    </message>
    <message>
        <source>%1, %2, %3 mm</source>
        <translation>%1, %2, %3 mm</translation>
    </message>
    <message>
        <source>All of the volume is shown.</source>
        <translation>Das ganze Volumen wird gezeigt.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>Remove from the cross-hair on</source>
        <translation>Ab dem Fadenkreuz entfernen</translation>
    </message>
    <message>
        <source>remove %1 side</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Removes all that lies %1 of the cross-hair</source>
        <translation>Entfernt alles, was vom Fadenkreuz aus %1 liegt</translation>
    </message>
    <message>
        <source>Keep only a slab</source>
        <translation>Nur einen Slab behalten</translation>
    </message>
    <message>
        <source>Removes all but a slab with the cross-hair in its middle</source>
        <translation>Entfernt alles außer einem Slab mit dem Fadenkreuz in seiner Mitte</translation>
    </message>
    <message>
        <source>Remove corner</source>
        <translation>Ecke entfernen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ClipsController</name>
    <message>
        <source>Cutting</source>
        <translation>Wird geschnitten</translation>
    </message>
    <message>
        <source>&amp;Clip</source>
        <translation>Besch&amp;nitt</translation>
    </message>
    <message>
        <source>&amp;Handles in the Pictures</source>
        <translation>&amp;Griffe in den Bildern</translation>
    </message>
    <message>
        <source>Drag faces, planes and balls of the clip where they are seen</source>
        <translation>Flächen, Ebenen und Kugeln des Beschnitts ziehen, wo sie zu sehen sind</translation>
    </message>
    <message>
        <source>&amp;Scissors</source>
        <translation>&amp;Schere</translation>
    </message>
    <message>
        <source>Draw around something in the 3D picture: it is removed. With Shift, all else is</source>
        <translation>Im 3D-Bild etwas umfahren: es wird entfernt. Mit Umschalt alles andere</translation>
    </message>
    <message>
        <source>Cut from the &amp;Eye</source>
        <translation>Schnitt vom &amp;Auge aus</translation>
    </message>
    <message>
        <source>Remove all that lies before a plane across the line of sight</source>
        <translation>Alles entfernen, was vor einer Ebene quer zur Blickrichtung liegt</translation>
    </message>
    <message>
        <source>&amp;No Clip</source>
        <translation>&amp;Kein Beschnitt</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ConvergeNow</name>
    <message>
        <source>%L1 %</source>
        <translation>%L1 %</translation>
    </message>
    <message>
        <source>Converging was stopped: another picture is shown.</source>
        <translation>Das Fertigzeichnen wurde angehalten: ein anderes Bild wird gezeigt.</translation>
    </message>
    <message>
        <source>Converging</source>
        <translation>Wird fertig gezeichnet</translation>
    </message>
    <message>
        <source>, noise %1</source>
        <translation>, Rauschen %1</translation>
    </message>
    <message>
        <source>, %1 s left</source>
        <translation>, noch %1 s</translation>
    </message>
    <message>
        <source>, %1 min left</source>
        <translation>, noch %1 min</translation>
    </message>
    <message>
        <source>, %1 h left</source>
        <translation>, noch %1 h</translation>
    </message>
    <message numerus="yes">
        <source>The picture is final: %Ln samples, noise %1 of black to white.</source>
        <translation>
            <numerusform>Das Bild ist endgültig: %Ln Abtastung, Rauschen %1 von Schwarz bis Weiß.</numerusform>
            <numerusform>Das Bild ist endgültig: %Ln Abtastungen, Rauschen %1 von Schwarz bis Weiß.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The picture is final: %Ln samples.</source>
        <translation>
            <numerusform>Das Bild ist endgültig: %Ln Abtastung.</numerusform>
            <numerusform>Das Bild ist endgültig: %Ln Abtastungen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::CurveController</name>
    <message>
        <source>Follow the Vessel</source>
        <translation>Dem Gefäß folgen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::CurvePanel</name>
    <message>
        <source>Along the Curve</source>
        <translation>Entlang der Kurve</translation>
    </message>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Kind of curved plane</source>
        <translation>Art der gekrümmten Ebene</translation>
    </message>
    <message>
        <source>Straightened: the curve is a straight line. Stretched: the surface along it is unrolled</source>
        <translation>Begradigt: Die Kurve ist eine gerade Linie. Gestreckt: Die Fläche entlang der Kurve ist abgerollt</translation>
    </message>
    <message>
        <source>Straightened</source>
        <translation>Begradigt</translation>
    </message>
    <message>
        <source>Stretched</source>
        <translation>Gestreckt</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Follow the Vessel</source>
        <translation>Dem Gefäß &amp;folgen</translation>
    </message>
    <message>
        <source>Looks for the way of a vessel, or another tube, through all points of the curve</source>
        <translation>Sucht den Verlauf eines Gefäßes oder einer anderen Röhre durch alle Punkte der Kurve</translation>
    </message>
    <message>
        <source>Planes &amp;Across</source>
        <translation>Ebenen &amp;quer</translation>
    </message>
    <message>
        <source>Turns the planes of all panes: the axial one is then across the curve</source>
        <translation>Dreht die Ebenen aller Bildfelder: Die axiale steht dann quer zur Kurve</translation>
    </message>
    <message>
        <source>&amp;Remove the Curve</source>
        <translation>Kurve &amp;entfernen</translation>
    </message>
    <message>
        <source>Removes all points of the curve</source>
        <translation>Entfernt alle Punkte der Kurve</translation>
    </message>
    <message>
        <source>Remove the Curve</source>
        <translation>Kurve entfernen</translation>
    </message>
    <message>
        <source>Looking for the vessel…</source>
        <translation>Das Gefäß wird gesucht…</translation>
    </message>
    <message>
        <source>Choose the curve tool (Y), and click the points of the curve on slices.</source>
        <translation>Wählen Sie das Kurvenwerkzeug (Y), und klicken Sie auf Schichten die Punkte der Kurve an.</translation>
    </message>
    <message>
        <source>Planes Across</source>
        <translation>Ebenen quer</translation>
    </message>
    <message>
        <source>Turn the plane about the curve, in °</source>
        <translation>Die Ebene um die Kurve drehen, in °</translation>
    </message>
    <message>
        <source>Height of the picture across the curve, in mm</source>
        <translation>Höhe des Bildes quer zur Kurve, in mm</translation>
    </message>
</context>
<context>
    <name>macula::viewer::CurveView</name>
    <message>
        <source>Curved plane</source>
        <translation>Gekrümmte Ebene</translation>
    </message>
    <message>
        <source>Click: the slices go there. Wheel, Left and Right: along the curve</source>
        <translation>Klick: Die Schichten gehen dorthin. Rad, Links und Rechts: entlang der Kurve</translation>
    </message>
    <message>
        <source>%1 mm along the curve, of %2 mm</source>
        <translation>%1 mm entlang der Kurve, von %2 mm</translation>
    </message>
    <message>
        <source>%1 of %2 mm along the curve</source>
        <translation>%1 von %2 mm entlang der Kurve</translation>
    </message>
    <message>
        <source>here %1 mm</source>
        <translation>hier %1 mm</translation>
    </message>
    <message>
        <source>Straightened: lengths hold along the line</source>
        <translation>Begradigt: Längen gelten entlang der Linie</translation>
    </message>
    <message>
        <source>Stretched: lengths hold along the curve and across it</source>
        <translation>Gestreckt: Längen gelten entlang der Kurve und quer zu ihr</translation>
    </message>
    <message>
        <source>Low values are white</source>
        <translation>Niedrige Werte sind weiß</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Invertiert</translation>
    </message>
    <message>
        <source>Some slices are interpolated</source>
        <translation>Einige Schichten sind interpoliert</translation>
    </message>
    <message>
        <source>The size of pixels is not calibrated</source>
        <translation>Die Größe der Pixel ist nicht kalibriert</translation>
    </message>
</context>
<context>
    <name>macula::viewer::CutTools</name>
    <message>
        <source>Show clip on slices</source>
        <translation>Beschnitt auf Schichten zeigen</translation>
    </message>
    <message>
        <source>Cut from the eye</source>
        <translation>Schnitt vom Auge aus</translation>
    </message>
    <message>
        <source>Goes with the camera</source>
        <translation>Geht mit der Kamera</translation>
    </message>
    <message>
        <source>Scissors</source>
        <translation>Schere</translation>
    </message>
    <message>
        <source>Undo all cuts</source>
        <translation>Alle Schnitte zurück</translation>
    </message>
    <message>
        <source>Before the eye</source>
        <translation>Vor dem Auge</translation>
    </message>
    <message>
        <source>Depth of the cut from the eye, in mm</source>
        <translation>Tiefe des Schnitts vom Auge aus, in mm</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>The cut goes with the camera</source>
        <translation>Der Schnitt geht mit der Kamera</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Scissors over the 3D picture</source>
        <translation>Schere über dem 3D-Bild</translation>
    </message>
    <message>
        <source>Undo all cuts with the scissors</source>
        <translation>Alle Schnitte mit der Schere zurücknehmen</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>Slices show dark what the clip removes, and its borders as lines</source>
        <translation>Schichten zeigen dunkel, was der Beschnitt entfernt, und seine Grenzen als Linien</translation>
    </message>
    <message>
        <source>Removes all that lies before a plane across the line of sight, at the cross-hair</source>
        <translation>Entfernt alles, was vor einer Ebene quer zur Blickrichtung am Fadenkreuz liegt</translation>
    </message>
    <message>
        <source>From the middle of the volume, in mm; below 0 is nearer to the eye. In the picture: Shift + wheel</source>
        <translation>Von der Mitte des Volumens, in mm; unter 0 ist näher am Auge. Im Bild: Umschalt + Rad</translation>
    </message>
    <message>
        <source>The plane stays across the line of sight; else it stays in the patient</source>
        <translation>Die Ebene bleibt quer zur Blickrichtung; sonst bleibt sie im Patienten</translation>
    </message>
    <message>
        <source>Draw around something in the 3D picture: it is removed. With Shift, all else is</source>
        <translation>Im 3D-Bild etwas umfahren: es wird entfernt. Mit Umschalt alles andere</translation>
    </message>
    <message>
        <source>Shows again what the scissors removed</source>
        <translation>Zeigt wieder, was die Schere entfernt hat</translation>
    </message>
    <message>
        <source>The clip has six planes: the cut from the eye is not shown.</source>
        <translation>Der Beschnitt hat sechs Ebenen: der Schnitt vom Auge aus wird nicht gezeigt.</translation>
    </message>
    <message>
        <source>There is no cut from the eye.</source>
        <translation>Es gibt keinen Schnitt vom Auge aus.</translation>
    </message>
    <message>
        <source>Nothing is cut with the scissors.</source>
        <translation>Mit der Schere ist nichts geschnitten.</translation>
    </message>
    <message>
        <source>Cuts: %1</source>
        <translation>Schnitte: %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::DistanceIn3d</name>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::DocumentDialog</name>
    <message>
        <source>Text of the document</source>
        <translation>Text des Dokuments</translation>
    </message>
    <message>
        <source>What the document says. Links go to the images that it names.</source>
        <translation>Was das Dokument sagt. Verweise führen zu den Bildern, die es nennt.</translation>
    </message>
    <message>
        <source>Images of the document</source>
        <translation>Bilder des Dokuments</translation>
    </message>
    <message>
        <source>The images that the document names, in its order. A double click or Enter shows one.</source>
        <translation>Die Bilder, die das Dokument nennt, in seiner Reihenfolge. Ein Doppelklick oder die Eingabetaste zeigt eines.</translation>
    </message>
    <message>
        <source>&amp;Previous Image</source>
        <translation>&amp;Voriges Bild</translation>
    </message>
    <message>
        <source>&amp;Next Image</source>
        <translation>&amp;Nächstes Bild</translation>
    </message>
    <message>
        <source>&amp;Open in the PDF Viewer…</source>
        <translation>Im PDF-Programm ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>In the program of this computer that shows PDF files</source>
        <translation>In dem Programm dieses Rechners, das PDF-Dateien zeigt</translation>
    </message>
    <message>
        <source>Save &amp;File As…</source>
        <translation>&amp;Datei speichern unter…</translation>
    </message>
    <message>
        <source>The file that the document holds</source>
        <translation>Die Datei, die das Dokument enthält</translation>
    </message>
    <message>
        <source>Take Over &amp;Measurements</source>
        <translation>&amp;Messungen übernehmen</translation>
    </message>
    <message>
        <source>Adds what the report measured to the slices of the open study</source>
        <translation>Fügt den Schichten der geöffneten Studie hinzu, was im Befund gemessen wurde</translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>The selected text, otherwise all of it</source>
        <translation>Der markierte Text, sonst der ganze</translation>
    </message>
    <message>
        <source>&amp;Save as Text…</source>
        <translation>Als &amp;Text speichern…</translation>
    </message>
    <message>
        <source>With the patient&apos;s name</source>
        <translation>Mit dem Namen des Patienten</translation>
    </message>
    <message>
        <source>not in this folder</source>
        <translation>nicht in diesem Ordner</translation>
    </message>
    <message>
        <source>Key images</source>
        <translation>Schlüsselbilder</translation>
    </message>
</context>
<context>
    <name>macula::viewer::DocumentsController</name>
    <message>
        <source>Open Doc&amp;ument…</source>
        <translation>Dok&amp;ument öffnen…</translation>
    </message>
    <message>
        <source>Read a report, a radiotherapy plan, a selection of key images or a PDF in DICOM</source>
        <translation>Einen Befund, einen Bestrahlungsplan, eine Auswahl von Schlüsselbildern oder ein PDF in DICOM lesen</translation>
    </message>
    <message>
        <source>Open a document</source>
        <translation>Dokument öffnen</translation>
    </message>
    <message>
        <source>Patients&apos; names are hidden, and a document may name the patient anywhere.</source>
        <translation>Namen sind ausgeblendet, und ein Dokument kann den Patienten überall nennen.</translation>
    </message>
    <message>
        <source>Show the names first: View, Patient and study over the picture.</source>
        <translation>Blenden Sie zuerst die Namen ein: Ansicht, Patient und Studie über dem Bild.</translation>
    </message>
    <message>
        <source>That image is not in the open folder.</source>
        <translation>Dieses Bild ist nicht im geöffneten Ordner.</translation>
    </message>
    <message>
        <source>Open the folder that it is in.</source>
        <translation>Öffnen Sie den Ordner, in dem es liegt.</translation>
    </message>
    <message>
        <source>That image is not in the open volume.</source>
        <translation>Dieses Bild ist nicht im geöffneten Volumen.</translation>
    </message>
    <message>
        <source>It could not be read, or was left out.</source>
        <translation>Es konnte nicht gelesen werden oder wurde ausgelassen.</translation>
    </message>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Open the PDF?</source>
        <translation>PDF öffnen?</translation>
    </message>
    <message>
        <source>Show this PDF in another program of this computer?</source>
        <translation>Dieses PDF in einem anderen Programm dieses Rechners zeigen?</translation>
    </message>
    <message>
        <source>Macula puts it into a private file, which it removes when it ends. The other program may keep a copy, or its name in a list.</source>
        <translation>Macula legt es in eine private Datei, die es beim Beenden löscht. Das andere Programm kann eine Kopie oder den Dateinamen in einer Liste behalten.</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>The file of this document is no PDF, and is not opened.</source>
        <translation>Die Datei dieses Dokuments ist kein PDF und wird nicht geöffnet.</translation>
    </message>
    <message>
        <source>Save it, and look at it with care.</source>
        <translation>Speichern Sie sie, und sehen Sie sie mit Vorsicht an.</translation>
    </message>
    <message>
        <source>This computer has no program that shows PDF files.</source>
        <translation>Dieser Rechner hat kein Programm, das PDF-Dateien zeigt.</translation>
    </message>
    <message>
        <source>Save the PDF, and open it on another computer.</source>
        <translation>Speichern Sie das PDF, und öffnen Sie es auf einem anderen Rechner.</translation>
    </message>
    <message>
        <source>Save the file of the document</source>
        <translation>Datei des Dokuments speichern</translation>
    </message>
    <message>
        <source>The file is written to %1.</source>
        <translation>Die Datei ist nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Save the text of the document</source>
        <translation>Text des Dokuments speichern</translation>
    </message>
    <message>
        <source>Text files (*.txt)</source>
        <translation>Textdateien (*.txt)</translation>
    </message>
    <message>
        <source>The text is written to %1.</source>
        <translation>Der Text ist nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>No series of DICOM images is open to take measurements onto.</source>
        <translation>Es ist keine Serie von DICOM-Bildern offen, auf die Messungen übernommen werden können.</translation>
    </message>
    <message>
        <source>Open the series that the report is about.</source>
        <translation>Öffnen Sie die Serie, um die es im Befund geht.</translation>
    </message>
    <message>
        <source>Measurements of a report</source>
        <translation>Messungen eines Befunds</translation>
    </message>
    <message numerus="yes">
        <source>%n measurements were taken over from the report.</source>
        <translation>
            <numerusform>%n Messung wurde aus dem Befund übernommen.</numerusform>
            <numerusform>%n Messungen wurden aus dem Befund übernommen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::DoseController</name>
    <message>
        <source>Nothing was computed: it was cancelled.</source>
        <translation>Nichts wurde berechnet: Es wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Show &amp;Dose</source>
        <translation>&amp;Dosis zeigen</translation>
    </message>
    <message>
        <source>Lays the dose of the treatment plan over the open images</source>
        <translation>Legt die Dosis des Bestrahlungsplans über die geöffneten Bilder</translation>
    </message>
    <message>
        <source>Dose-&amp;Volume Histogram…</source>
        <translation>Dosis-&amp;Volumen-Histogramm…</translation>
    </message>
    <message>
        <source>How much dose each region of the structure set receives</source>
        <translation>Wie viel Dosis jede Region des Struktursatzes erhält</translation>
    </message>
    <message>
        <source>Computing the dose in regions</source>
        <translation>Die Dosis in Regionen wird berechnet</translation>
    </message>
    <message>
        <source>Save the dose in regions</source>
        <translation>Die Dosis in Regionen speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>The dose in regions is written to %1.</source>
        <translation>Die Dosis in Regionen ist nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>There is a dose on these images (%1): View, Show Dose.</source>
        <translation>Zu diesen Bildern gibt es eine Dosis (%1): Ansicht, Dosis zeigen.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::DosePanel</name>
    <message>
        <source>Show Dose</source>
        <translation>Dosis zeigen</translation>
    </message>
    <message>
        <source>Dose-Volume Histogram…</source>
        <translation>Dosis-Volumen-Histogramm…</translation>
    </message>
    <message>
        <source>Dose</source>
        <translation>Dosis</translation>
    </message>
    <message>
        <source>The doses that lie on the open images</source>
        <translation>Die Dosen, die auf den geöffneten Bildern liegen</translation>
    </message>
    <message>
        <source>Lays the dose over the open images, with isodose lines</source>
        <translation>Legt die Dosis über die geöffneten Bilder, mit Isodosenlinien</translation>
    </message>
    <message>
        <source>How much dose each region of the structure set receives, as curves and figures</source>
        <translation>Wie viel Dosis jede Region des Struktursatzes erhält, als Kurven und Zahlen</translation>
    </message>
    <message>
        <source>Isodose lines</source>
        <translation>Isodosenlinien</translation>
    </message>
    <message>
        <source>Lines of equal dose over the slices</source>
        <translation>Linien gleicher Dosis über den Schichten</translation>
    </message>
    <message>
        <source>Unit of the levels</source>
        <translation>Einheit der Stufen</translation>
    </message>
    <message>
        <source>Whether levels are percentages or doses</source>
        <translation>Ob Stufen Prozente oder Dosen sind</translation>
    </message>
    <message>
        <source>Percent</source>
        <translation>Prozent</translation>
    </message>
    <message>
        <source>Dose that is 100 percent</source>
        <translation>Dosis, die 100 Prozent ist</translation>
    </message>
    <message>
        <source>Another dose as 100 percent; 0: the prescription of the plan, else the highest dose</source>
        <translation>Eine andere Dosis als 100 Prozent; 0: die Verschreibung des Plans, sonst die höchste Dosis</translation>
    </message>
    <message>
        <source>by itself</source>
        <translation>von selbst</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>One more line</source>
        <translation>Eine Linie mehr</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the chosen line</source>
        <translation>Entfernt die gewählte Linie</translation>
    </message>
    <message>
        <source>Usual</source>
        <translation>Üblich</translation>
    </message>
    <message>
        <source>The usual levels and colours</source>
        <translation>Die üblichen Stufen und Farben</translation>
    </message>
    <message>
        <source>Levels in</source>
        <translation>Stufen in</translation>
    </message>
    <message>
        <source>100 % =</source>
        <translation>100 % =</translation>
    </message>
    <message>
        <source>Dose %1: %2</source>
        <translation>Dosis %1: %2</translation>
    </message>
    <message>
        <source>No dose of this folder lies in the coordinate system of the open images.</source>
        <translation>Keine Dosis dieses Ordners liegt im Koordinatensystem der geöffneten Bilder.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>It lies in the frame of reference of these images; nothing is registered.</source>
        <translation>Sie liegt im Koordinatensystem (Frame of Reference) dieser Bilder; nichts wird registriert.</translation>
    </message>
    <message>
        <source>100 % is %1.</source>
        <translation>100 % sind %1.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::DvhChart</name>
    <message>
        <source>Dose-volume histogram</source>
        <translation>Dosis-Volumen-Histogramm</translation>
    </message>
    <message>
        <source>How much of each region receives at least a dose</source>
        <translation>Wie viel von jeder Region mindestens eine Dosis erhält</translation>
    </message>
    <message>
        <source>%1: %2 % receive %3 %4 or more</source>
        <translation>%1: %2 % erhalten %3 %4 oder mehr</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Dose (%1); upwards: share of the region that receives at least this dose</source>
        <translation>Dosis (%1); nach oben: Anteil der Region, der mindestens diese Dosis erhält</translation>
    </message>
</context>
<context>
    <name>macula::viewer::DvhDialog</name>
    <message>
        <source>Dose-Volume Histogram</source>
        <translation>Dosis-Volumen-Histogramm</translation>
    </message>
    <message>
        <source>Dose in each region</source>
        <translation>Dosis in jeder Region</translation>
    </message>
    <message>
        <source>A check mark shows the curve of a region. D95 is the dose that 95 % of the region receive at least; V20 is the share that receives 20 Gy or more</source>
        <translation>Ein Häkchen zeigt die Kurve einer Region. D95 ist die Dosis, die 95 % der Region mindestens erhalten; V20 ist der Anteil, der 20 Gy oder mehr erhält</translation>
    </message>
    <message>
        <source>&amp;Copy as Table</source>
        <translation>Als Tabelle &amp;kopieren</translation>
    </message>
    <message>
        <source>All figures as CSV, to paste into a spreadsheet</source>
        <translation>Alle Zahlen als CSV, zum Einfügen in eine Tabellenkalkulation</translation>
    </message>
    <message>
        <source>&amp;Save as Table…</source>
        <translation>Als Tabelle &amp;speichern…</translation>
    </message>
    <message>
        <source>All figures in a file (CSV)</source>
        <translation>Alle Zahlen in einer Datei (CSV)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Region</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>Outside (%)</source>
        <translation>Außerhalb (%)</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>D98</source>
        <translation>D98</translation>
    </message>
    <message>
        <source>D95</source>
        <translation>D95</translation>
    </message>
    <message>
        <source>D50</source>
        <translation>D50</translation>
    </message>
    <message>
        <source>D2</source>
        <translation>D2</translation>
    </message>
    <message>
        <source>V20 Gy (%)</source>
        <translation>V20 Gy (%)</translation>
    </message>
    <message>
        <source>V95 % (%)</source>
        <translation>V95 % (%)</translation>
    </message>
    <message>
        <source>V100 % (%)</source>
        <translation>V100 % (%)</translation>
    </message>
    <message>
        <source>V107 % (%)</source>
        <translation>V107 % (%)</translation>
    </message>
</context>
<context>
    <name>macula::viewer::FaceRow</name>
    <message>
        <source>Clip face, %1, slider</source>
        <translation>Schnittfläche %1, Schieber</translation>
    </message>
    <message>
        <source>Clip face, %1, in mm</source>
        <translation>Schnittfläche %1, in mm</translation>
    </message>
    <message>
        <source>Open the clip face, %1</source>
        <translation>Schnittfläche %1 öffnen</translation>
    </message>
    <message>
        <source>Where the %1 face of what is shown is, in mm of the patient (LPS)</source>
        <translation>Wo die Fläche %1 des Gezeigten ist, in mm des Patienten (LPS)</translation>
    </message>
    <message>
        <source>Show all of the volume on the %1 side again</source>
        <translation>Auf der Seite %1 wieder das ganze Volumen zeigen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::FidelityBadge</name>
    <message>
        <source>Final</source>
        <translation>Endgültig</translation>
    </message>
    <message>
        <source>Preliminary</source>
        <translation>Vorläufig</translation>
    </message>
    <message>
        <source>Nothing will change any more</source>
        <translation>Es ändert sich nichts mehr</translation>
    </message>
    <message>
        <source>The picture gets better</source>
        <translation>Das Bild wird noch besser</translation>
    </message>
</context>
<context>
    <name>macula::viewer::FollowUpController</name>
    <message>
        <source>Follow-up of &amp;Lesions…</source>
        <translation>Verlauf der &amp;Läsionen…</translation>
    </message>
    <message>
        <source>Sizes of lesions with the same label in the studies of this patient, sums and their changes</source>
        <translation>Größen der gleich beschrifteten Läsionen in den Untersuchungen dieses Patienten, Summen und ihre Änderung</translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation>Es ist keine Untersuchung offen.</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Untersuchung.</translation>
    </message>
    <message numerus="yes">
        <source>What was measured before could not be read everywhere; left out were %n states.</source>
        <translation>
            <numerusform>Was früher gemessen wurde, war nicht überall lesbar; weggelassen wurde %n Stand.</numerusform>
            <numerusform>Was früher gemessen wurde, war nicht überall lesbar; weggelassen wurden %n Stände.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n studies have no date, and are left out.</source>
        <translation>
            <numerusform>%n Untersuchung hat kein Datum und ist weggelassen.</numerusform>
            <numerusform>%n Untersuchungen haben kein Datum und sind weggelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The open study has no date: others cannot be compared with it, and are left out.</source>
        <translation>Die offene Untersuchung hat kein Datum: Andere können nicht mit ihr verglichen werden und sind weggelassen.</translation>
    </message>
    <message>
        <source>Whether the sizes of other studies are calibrated is not known here.</source>
        <translation>Ob die Größen anderer Untersuchungen kalibriert sind, ist hier nicht bekannt.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::FollowUpDialog</name>
    <message>
        <source>&amp;Gone</source>
        <translation>Ver&amp;schwunden</translation>
    </message>
    <message>
        <source>Follow-up</source>
        <translation>Verlauf der Läsionen</translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation>Ausgangsuntersuchung</translation>
    </message>
    <message>
        <source>The study that the later ones are compared with: the last before the treatment</source>
        <translation>Die Untersuchung, mit der die späteren verglichen werden: die letzte vor der Behandlung</translation>
    </message>
    <message>
        <source>Lesions in each study, in mm</source>
        <translation>Läsionen in jeder Untersuchung, in mm</translation>
    </message>
    <message>
        <source>Sizes in mm</source>
        <translation>Größen in mm</translation>
    </message>
    <message>
        <source>Gone</source>
        <translation>Verschwunden</translation>
    </message>
    <message>
        <source>The lesion of the chosen field is no longer seen in that study: its size is 0</source>
        <translation>Die Läsion des gewählten Feldes ist in dieser Untersuchung nicht mehr zu sehen: Ihre Größe ist 0</translation>
    </message>
    <message>
        <source>&amp;Baseline</source>
        <translation>&amp;Ausgangsuntersuchung</translation>
    </message>
    <message>
        <source>&amp;Copy as a Table</source>
        <translation>Als Tabelle &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Save as a Table…</source>
        <translation>Als Tabelle &amp;speichern…</translation>
    </message>
    <message>
        <source>%1 (lymph node, short axis)</source>
        <translation>%1 (Lymphknoten, kurze Achse)</translation>
    </message>
    <message>
        <source>%1 (not at the baseline)</source>
        <translation>%1 (nicht in der Ausgangsuntersuchung)</translation>
    </message>
    <message>
        <source>0 (gone)</source>
        <translation>0 (verschwunden)</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>Sum in mm</source>
        <translation>Summe in mm</translation>
    </message>
    <message>
        <source>From the baseline</source>
        <translation>Gegen die Ausgangsuntersuchung</translation>
    </message>
    <message>
        <source>From the smallest sum before</source>
        <translation>Gegen die kleinste Summe davor</translation>
    </message>
    <message>
        <source>RECIST 1.1</source>
        <translation>RECIST 1.1</translation>
    </message>
    <message>
        <source>The categories are what RECIST 1.1 gives for these sizes alone. New lesions and lesions that are not measured (non-target lesions) are not in them. A physician decides.</source>
        <translation>Die Kategorien sind, was RECIST 1.1 für diese Größen allein ergibt. Neue Läsionen und Läsionen, die nicht gemessen werden (Non-Target-Läsionen), sind nicht darin. Eine Ärztin oder ein Arzt entscheidet.</translation>
    </message>
    <message>
        <source>Measure lesions with both axes (Shift+D), and give the same lesion the same label in each study.</source>
        <translation>Messen Sie Läsionen mit beiden Achsen (Umschalt+D), und geben Sie derselben Läsion in jeder Untersuchung dieselbe Beschriftung.</translation>
    </message>
    <message>
        <source>Only this study is known. Open a prior in its place, measure there, and come back: what is measured is kept. Priors of this folder are known, and those of the folder that is open beside it (Ctrl+B).</source>
        <translation>Nur diese Untersuchung ist bekannt. Öffnen Sie eine Voruntersuchung an ihrer Stelle, messen Sie dort, und kommen Sie zurück: Was gemessen ist, wird behalten. Bekannt sind die Voruntersuchungen dieses Ordners und des Ordners, der daneben offen ist (Strg+B).</translation>
    </message>
    <message>
        <source>The size of the pixels of the open study is not calibrated: its lengths are estimates.</source>
        <translation>Die Pixelgröße der offenen Untersuchung ist nicht kalibriert: Ihre Längen sind Schätzungen.</translation>
    </message>
    <message>
        <source>Save the follow-up</source>
        <translation>Den Verlauf speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>The follow-up is written to %1.</source>
        <translation>Der Verlauf ist nach %1 geschrieben.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::FoundStudyList</name>
    <message>
        <source>Enter or a double click opens the selected study</source>
        <translation>Eingabe oder ein Doppelklick öffnet die gewählte Studie</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>Abrufen</translation>
    </message>
    <message>
        <source>Fetch the selected study in the background, and keep it on this machine</source>
        <translation>Die gewählte Studie im Hintergrund abrufen und auf diesem Rechner behalten</translation>
    </message>
    <message>
        <source>Beside</source>
        <translation>Daneben</translation>
    </message>
    <message>
        <source>Show the selected study beside the open one, as a second volume</source>
        <translation>Die gewählte Studie als zweites Volumen neben der geöffneten zeigen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Show the selected study; from an archive as soon as images are there</source>
        <translation>Die gewählte Studie zeigen; aus einem Archiv, sobald Bilder da sind</translation>
    </message>
    <message>
        <source>A right click chooses the columns; drag to move them, click to sort</source>
        <translation>Ein Rechtsklick wählt die Spalten; Ziehen verschiebt, Klicken sortiert</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Mark as Read</source>
        <translation>Als gelesen markieren</translation>
    </message>
    <message>
        <source>A study that is marked stands as read; Space marks it, or takes it back</source>
        <translation>Eine markierte Untersuchung gilt als gelesen; die Leertaste markiert sie oder nimmt es zurück</translation>
    </message>
    <message>
        <source>Mark as Not Read</source>
        <translation>Als nicht gelesen markieren</translation>
    </message>
</context>
<context>
    <name>macula::viewer::FoundStudyModel</name>
    <message>
        <source>hidden</source>
        <translation>ausgeblendet</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Patient ID</source>
        <translation>Patienten-ID</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>Geboren</translation>
    </message>
    <message>
        <source>Study date</source>
        <translation>Studiendatum</translation>
    </message>
    <message>
        <source>Modalities</source>
        <translation>Modalitäten</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Accession number</source>
        <translation>Accession-Nummer</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>this machine</source>
        <translation>dieser Rechner</translation>
    </message>
    <message>
        <source>%1, fetched</source>
        <translation>%1, abgerufen</translation>
    </message>
    <message>
        <source>%1, partly fetched</source>
        <translation>%1, zum Teil abgerufen</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>opened</source>
        <translation>geöffnet</translation>
    </message>
    <message>
        <source>read</source>
        <translation>gelesen</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Gelesen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::HangingController</name>
    <message>
        <source>&amp;Boxes of Images</source>
        <translation>Bil&amp;dfelder</translation>
    </message>
    <message>
        <source>As &amp;Acquired</source>
        <translation>Wie &amp;aufgenommen</translation>
    </message>
    <message>
        <source>Show the slices of the open volume as they were acquired, and priors beside them</source>
        <translation>Die Schichten des offenen Volumens wie aufgenommen zeigen, mit Voruntersuchungen daneben</translation>
    </message>
    <message>
        <source>Hanging protocol</source>
        <translation>Hängeprotokoll</translation>
    </message>
    <message>
        <source>&amp;Scroll Together</source>
        <translation>&amp;Zusammen blättern</translation>
    </message>
    <message>
        <source>By the place in the patient; across studies as the boxes lie now</source>
        <translation>Nach dem Ort im Patienten; zwischen Untersuchungen so, wie die Felder jetzt stehen</translation>
    </message>
    <message>
        <source>This Box A&amp;lone</source>
        <translation>Dieses Feld a&amp;llein</translation>
    </message>
    <message>
        <source>The box that is chosen, or all of them again</source>
        <translation>Das gewählte Feld, oder wieder alle</translation>
    </message>
    <message>
        <source>In a &amp;Window of Their Own</source>
        <translation>In einem eigenen &amp;Fenster</translation>
    </message>
    <message>
        <source>On another screen where there is one, while this window shows the volume</source>
        <translation>Auf einem anderen Bildschirm, wo es einen gibt, während dieses Fenster das Volumen zeigt</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Rows and columns of boxes</source>
        <translation>Zeilen und Spalten von Feldern</translation>
    </message>
    <message>
        <source>&amp;Other Grid…</source>
        <translation>&amp;Anderes Raster…</translation>
    </message>
    <message>
        <source>Any number of rows and columns</source>
        <translation>Beliebig viele Zeilen und Spalten</translation>
    </message>
    <message>
        <source>Hang the study by this protocol</source>
        <translation>Die Untersuchung nach diesem Protokoll hängen</translation>
    </message>
    <message>
        <source>It is for other studies.</source>
        <translation>Es ist für andere Untersuchungen.</translation>
    </message>
    <message>
        <source>Save as &amp;Hanging Protocol…</source>
        <translation>Als &amp;Hängeprotokoll speichern…</translation>
    </message>
    <message>
        <source>Hang studies of this kind as these boxes are now</source>
        <translation>Untersuchungen dieser Art so hängen, wie diese Felder jetzt sind</translation>
    </message>
    <message>
        <source>&amp;Remove Hanging Protocol</source>
        <translation>Hängeprotokoll &amp;entfernen</translation>
    </message>
    <message>
        <source>Boxes of Images</source>
        <translation>Bildfelder</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Save as Hanging Protocol</source>
        <translation>Als Hängeprotokoll speichern</translation>
    </message>
    <message>
        <source>Name; one of the same name is replaced</source>
        <translation>Name; eines mit demselben Namen wird ersetzt</translation>
    </message>
    <message>
        <source>Studies of this kind are hung so from now on.</source>
        <translation>Untersuchungen dieser Art werden von nun an so gehängt.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::HeadsetController</name>
    <message>
        <source>Looking for the headset</source>
        <translation>Das Headset wird gesucht</translation>
    </message>
    <message>
        <source>Show in &amp;Headset</source>
        <translation>Im &amp;Headset zeigen</translation>
    </message>
    <message>
        <source>This study in a headset (OpenXR), to be held, turned and cut by hand</source>
        <translation>Diese Studie in einem Headset (OpenXR), mit der Hand zu halten, zu drehen und zu schneiden</translation>
    </message>
    <message>
        <source>There is nothing to show in a headset yet.</source>
        <translation>Es gibt noch nichts, was im Headset gezeigt werden kann.</translation>
    </message>
    <message>
        <source>In the headset</source>
        <translation>Im Headset</translation>
    </message>
</context>
<context>
    <name>macula::viewer::HeadsetMirror</name>
    <message>
        <source>Patient and study</source>
        <translation>Patient und Studie</translation>
    </message>
    <message>
        <source>What the left eye sees in the headset</source>
        <translation>Was das linke Auge im Headset sieht</translation>
    </message>
    <message>
        <source>Whose study is in the headset, above the mirror; off at each start</source>
        <translation>Wessen Studie im Headset ist, über dem Spiegelbild; bei jedem Start aus</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Show in Headset</source>
        <translation>Im Headset zeigen</translation>
    </message>
    <message>
        <source>End the session in the headset; the window goes on</source>
        <translation>Die Sitzung im Headset beenden; das Fenster läuft weiter</translation>
    </message>
    <message>
        <source>The study of this window in a headset (OpenXR)</source>
        <translation>Die Studie dieses Fensters in einem Headset (OpenXR)</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ImageBox</name>
    <message>
        <source>The image is being read…</source>
        <translation>Das Bild wird gelesen…</translation>
    </message>
    <message>
        <source>lines: the slices of the open volume</source>
        <translation>Linien: die Schichten des offenen Volumens</translation>
    </message>
    <message>
        <source>the file says no rate: %1 frames per second</source>
        <translation>die Datei nennt keine Rate: %1 Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>line: the image of the box that is chosen</source>
        <translation>Linie: das Bild des gewählten Feldes</translation>
    </message>
    <message>
        <source>scrolls with the others</source>
        <translation>blättert mit den anderen</translation>
    </message>
    <message>
        <source>an older study, of %1</source>
        <translation>eine ältere Untersuchung, vom %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ImageBoxes</name>
    <message>
        <source>Boxes of images</source>
        <translation>Bildfelder</translation>
    </message>
    <message>
        <source>Series in a box</source>
        <translation>Serie in einem Feld</translation>
    </message>
    <message>
        <source>Scroll together</source>
        <translation>Zusammen blättern</translation>
    </message>
    <message>
        <source>Scroll alone</source>
        <translation>Allein blättern</translation>
    </message>
    <message>
        <source>That series is of another patient. Boxes show one patient; a double click opens it.</source>
        <translation>Diese Serie ist von einem anderen Patienten. Felder zeigen einen Patienten; ein Doppelklick öffnet sie.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::IsodoseTable</name>
    <message>
        <source>Isodoses</source>
        <translation>Isodosen</translation>
    </message>
    <message>
        <source>Levels of the lines. Double click: another level, or another colour</source>
        <translation>Stufen der Linien. Doppelklick: eine andere Stufe oder eine andere Farbe</translation>
    </message>
    <message>
        <source>Dose</source>
        <translation>Dosis</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
</context>
<context>
    <name>macula::viewer::KeptSegments</name>
    <message>
        <source>Own segments</source>
        <translation>Eigene Segmente</translation>
    </message>
</context>
<context>
    <name>macula::viewer::KeyImagesController</name>
    <message>
        <source>Next &amp;Key Image</source>
        <translation>Nächstes S&amp;chlüsselbild</translation>
    </message>
    <message>
        <source>The next image that a selection of key images names</source>
        <translation>Das nächste Bild, das eine Auswahl von Schlüsselbildern nennt</translation>
    </message>
    <message>
        <source>Previous Key Image</source>
        <translation>Voriges Schlüsselbild</translation>
    </message>
    <message>
        <source>The key image before</source>
        <translation>Das Schlüsselbild davor</translation>
    </message>
    <message>
        <source>Key image %1 of %2: %3</source>
        <translation>Schlüsselbild %1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>macula::viewer::KeysPage</name>
    <message>
        <source>&amp;No Key</source>
        <translation>&amp;Keine Taste</translation>
    </message>
    <message>
        <source>&amp;Usual Key</source>
        <translation>&amp;Übliche Taste</translation>
    </message>
    <message>
        <source>&amp;All as Usual</source>
        <translation>&amp;Alle wie üblich</translation>
    </message>
    <message>
        <source>Search the actions and keys</source>
        <translation>Befehle und Tasten durchsuchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Words of an action, or a key such as F3</source>
        <translation>Wörter eines Befehls oder eine Taste wie F3</translation>
    </message>
    <message>
        <source>New key of the selected action</source>
        <translation>Neue Taste des gewählten Befehls</translation>
    </message>
    <message>
        <source>Press the new key of the selected action, with Ctrl, Shift or Alt where wanted</source>
        <translation>Drücken Sie die neue Taste des gewählten Befehls, bei Bedarf mit Strg, Umschalt oder Alt</translation>
    </message>
    <message>
        <source>The selected action has no key</source>
        <translation>Der gewählte Befehl hat keine Taste</translation>
    </message>
    <message>
        <source>The selected action has the key again that it came with</source>
        <translation>Der gewählte Befehl hat wieder die mitgelieferte Taste</translation>
    </message>
    <message>
        <source>All actions have the keys again that they came with</source>
        <translation>Alle Befehle haben wieder die mitgelieferten Tasten</translation>
    </message>
    <message>
        <source>What the mouse does, and arrows, digits and letters on slices, is fixed: F1 shows it.</source>
        <translation>Was die Maus tut, und Pfeile, Ziffern und Buchstaben auf Schichten, steht fest: F1 zeigt es.</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>What the window can do, and the key for it; those you have changed are bold</source>
        <translation>Was das Fenster kann und die Taste dafür; fett ist, was Sie geändert haben</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LabelEditor</name>
    <message>
        <source>Label of the measurement</source>
        <translation>Beschriftung der Messung</translation>
    </message>
    <message>
        <source>Label of the measurement. Enter keeps it, Esc leaves it as it was</source>
        <translation>Beschriftung der Messung. Eingabe behält sie, Esc lässt sie, wie sie war</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LabelMapOpener</name>
    <message>
        <source>A segmentation is shown on a volume.</source>
        <translation>Eine Segmentierung wird auf einem Volumen gezeigt.</translation>
    </message>
    <message>
        <source>Open the volume first that it was drawn on.</source>
        <translation>Öffnen Sie zuerst das Volumen, auf dem sie gezeichnet wurde.</translation>
    </message>
    <message>
        <source>Open a segmentation of this volume</source>
        <translation>Eine Segmentierung dieses Volumens öffnen</translation>
    </message>
    <message>
        <source>Label maps: NIfTI, NRRD, MetaImage (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.hdr)</source>
        <translation>Label-Maps: NIfTI, NRRD, MetaImage (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.hdr)</translation>
    </message>
    <message numerus="yes">
        <source>%n segments are shown; the panel Segmentations (F11) lists them.</source>
        <translation>
            <numerusform>%n Segment ist zu sehen; das Feld Segmentierungen (F11) führt es auf.</numerusform>
            <numerusform>%n Segmente sind zu sehen; das Feld Segmentierungen (F11) führt sie auf.</numerusform>
        </translation>
    </message>
    <message>
        <source>A segmentation?</source>
        <translation>Eine Segmentierung?</translation>
    </message>
    <message>
        <source>%1 lies on the voxels of the volume that is open. Is it a segmentation of this volume?</source>
        <translation>%1 liegt auf den Voxeln des geöffneten Volumens. Ist es eine Segmentierung dieses Volumens?</translation>
    </message>
    <message>
        <source>Show It as a &amp;Segmentation</source>
        <translation>Als &amp;Segmentierung zeigen</translation>
    </message>
    <message>
        <source>Open It as a &amp;Volume</source>
        <translation>Als &amp;Volumen öffnen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LightsController</name>
    <message>
        <source>Lights</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>  Lights </source>
        <translation>  Beleuchtung </translation>
    </message>
    <message>
        <source>Where the light comes from</source>
        <translation>Woher das Licht kommt</translation>
    </message>
    <message>
        <source>Only Cinematic and Clear have lights</source>
        <translation>Nur Cinematic und Klar haben eine Beleuchtung</translation>
    </message>
    <message>
        <source>Save the lights</source>
        <translation>Lichter speichern</translation>
    </message>
    <message>
        <source>Lights (*.json)</source>
        <translation>Lichter (*.json)</translation>
    </message>
    <message>
        <source>The lights are written to %1. Use them with --lights %1.</source>
        <translation>Die Lichter sind nach %1 geschrieben. Verwenden Sie sie mit --lights %1.</translation>
    </message>
    <message>
        <source>Open lights</source>
        <translation>Lichter öffnen</translation>
    </message>
    <message>
        <source>Lights (*.json);;All files (*)</source>
        <translation>Lichter (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LightsEditing</name>
    <message>
        <source>There is no light that could be changed.</source>
        <translation>Es gibt kein Licht, das geändert werden könnte.</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Add a light first.</source>
        <translation>Fügen Sie zuerst ein Licht hinzu.</translation>
    </message>
    <message>
        <source>Only Cinematic and Clear have lights.</source>
        <translation>Nur Cinematic und Klar haben Lichter.</translation>
    </message>
    <message>
        <source>Open a study, and choose one of these looks.</source>
        <translation>Öffnen Sie eine Studie und wählen Sie eine dieser Darstellungen.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LightsPanel</name>
    <message>
        <source>Lights</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open lights of a file</source>
        <translation>Lichter aus einer Datei öffnen</translation>
    </message>
    <message>
        <source>Lights that were saved here, or a light rig of your own (JSON)</source>
        <translation>Lichter, die hier gespeichert wurden, oder eine eigene Anordnung (JSON)</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>Save the lights to a file</source>
        <translation>Lichter in einer Datei speichern</translation>
    </message>
    <message>
        <source>For other studies, and for --lights</source>
        <translation>Für andere Studien und für --lights</translation>
    </message>
    <message>
        <source>One light: drag it in the picture</source>
        <translation>Ein Licht: im Bild zu ziehen</translation>
    </message>
    <message>
        <source>Which light</source>
        <translation>Welches Licht</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation>Ein Licht hinzufügen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove this light</source>
        <translation>Dieses Licht entfernen</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>Radiance of the disc; in the picture Shift and the wheel</source>
        <translation>Strahldichte der Scheibe; im Bild Umschalt und Mausrad</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Colour of this light</source>
        <translation>Farbe dieses Lichts</translation>
    </message>
    <message>
        <source>All lights</source>
        <translation>Alle Lichter</translation>
    </message>
    <message>
        <source>What the lights keep to</source>
        <translation>Woran sich die Lichter halten</translation>
    </message>
    <message>
        <source>the patient</source>
        <translation>am Patienten</translation>
    </message>
    <message>
        <source>the camera</source>
        <translation>an der Kamera</translation>
    </message>
    <message>
        <source>Lights that keep to the camera leave the preview in motion without a model</source>
        <translation>Mit Lichtern an der Kamera hat die Vorschau in Bewegung kein Modell</translation>
    </message>
    <message>
        <source>Sky</source>
        <translation>Himmel</translation>
    </message>
    <message>
        <source>Light from everywhere: less shows more relief, more shows what lies in shadow</source>
        <translation>Licht von überall: weniger zeigt mehr Relief, mehr zeigt, was im Schatten liegt</translation>
    </message>
    <message>
        <source>Turned</source>
        <translation>Gedreht</translation>
    </message>
    <message>
        <source>Strength of all</source>
        <translation>Stärke aller</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>Find the exposure</source>
        <translation>Belichtung finden</translation>
    </message>
    <message>
        <source>Once, for what is seen now, as a camera does; it stays until it is changed</source>
        <translation>Einmal, für das, was jetzt zu sehen ist, wie eine Kamera; sie bleibt, bis sie geändert wird</translation>
    </message>
    <message>
        <source>Keep to</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>Colour of the light</source>
        <translation>Farbe des Lichts</translation>
    </message>
    <message>
        <source>Light %1</source>
        <translation>Licht %1</translation>
    </message>
    <message>
        <source>Where the light comes from</source>
        <translation>Woher das Licht kommt</translation>
    </message>
    <message>
        <source>The light that the numbers below are of</source>
        <translation>Das Licht, zu dem die Zahlen darunter gehören</translation>
    </message>
    <message>
        <source>One more light, from above the viewer&apos;s left shoulder</source>
        <translation>Ein weiteres Licht, von über der linken Schulter des Betrachters</translation>
    </message>
    <message>
        <source>Take the chosen light out of the rig</source>
        <translation>Das gewählte Licht entfernen</translation>
    </message>
    <message>
        <source>In °: 0 is anterior, or the viewer; positive to the patient&apos;s left, or to the right of the picture</source>
        <translation>In °: 0 ist vorn oder der Betrachter; positiv nach links des Patienten oder nach rechts im Bild</translation>
    </message>
    <message>
        <source>In °: positive is superior, or up in the picture</source>
        <translation>In °: positiv ist oben am Patienten oder oben im Bild</translation>
    </message>
    <message>
        <source>Of the disc on the sky, in °: smaller is harder, with sharper shadows and highlights</source>
        <translation>Der Scheibe am Himmel, in °: kleiner ist härter, mit schärferen Schatten und Glanzlichtern</translation>
    </message>
    <message>
        <source>Choose the colour of this light (sRGB); its strength is a number of its own</source>
        <translation>Die Farbe dieses Lichts wählen (sRGB); seine Stärke ist eine eigene Zahl</translation>
    </message>
    <message>
        <source>All lights about the vertical, in °; positive to the patient&apos;s left</source>
        <translation>Alle Lichter um die Senkrechte, in °; positiv nach links des Patienten</translation>
    </message>
    <message>
        <source>Multiplies all lights and the sky</source>
        <translation>Vervielfacht alle Lichter und den Himmel</translation>
    </message>
    <message>
        <source>Multiplies the picture before the tone map</source>
        <translation>Vervielfacht das Bild vor der Tonwertkurve</translation>
    </message>
    <message>
        <source>Rig of lights</source>
        <translation>Anordnung der Lichter</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LinkChoice</name>
    <message>
        <source>Studies of a Link</source>
        <translation>Studien eines Links</translation>
    </message>
    <message>
        <source>Studies that fit the link</source>
        <translation>Studien, die zum Link passen</translation>
    </message>
    <message>
        <source>Enter or a double click opens the selected study</source>
        <translation>Eingabe oder ein Doppelklick öffnet die gewählte Studie</translation>
    </message>
    <message numerus="yes">
        <source>%n studies fit the link. Choose the one to fetch and open.</source>
        <translation>
            <numerusform>%n Studie passt zum Link. Wählen Sie sie, um sie abzurufen und zu öffnen.</numerusform>
            <numerusform>%n Studien passen zum Link. Wählen Sie die, die abgerufen und geöffnet werden soll.</numerusform>
        </translation>
    </message>
    <message>
        <source>In the archive %1.</source>
        <translation>Im Archiv %1.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LinksController</name>
    <message>
        <source>Another link came while a question about a link was open, and was not followed.</source>
        <translation>Ein weiterer Link kam, während eine Frage zu einem Link offen war; ihm wurde nicht gefolgt.</translation>
    </message>
    <message>
        <source>Answer the question, then click on the link again.</source>
        <translation>Beantworten Sie die Frage, und klicken Sie dann noch einmal auf den Link.</translation>
    </message>
    <message>
        <source>Asking for the study</source>
        <translation>Nach der Studie wird gefragt</translation>
    </message>
</context>
<context>
    <name>macula::viewer::LookController</name>
    <message>
        <source>&amp;Look</source>
        <translation>Dar&amp;stellung</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>&amp;Shade Ray Cast</source>
        <translation>Volumen-Rendering &amp;schattieren</translation>
    </message>
    <message>
        <source>Light ray casts from the eye, as much as the preset says</source>
        <translation>Volumen-Rendering vom Auge aus beleuchten, so viel die Voreinstellung vorgibt</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Linear</translation>
    </message>
    <message>
        <source>Values between eight voxels, as other viewers show them</source>
        <translation>Werte zwischen acht Voxeln, wie andere Betrachter sie zeigen</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Glatt</translation>
    </message>
    <message>
        <source>Fewest rings on skin and bone, and a voxel softer</source>
        <translation>Die wenigsten Ringe auf Haut und Knochen, und ein Voxel weicher</translation>
    </message>
    <message>
        <source>S&amp;harp</source>
        <translation>&amp;Scharf</translation>
    </message>
    <message>
        <source>Fine detail as with Linear, and somewhat fewer rings</source>
        <translation>Feine Einzelheiten wie bei Linear, und etwas weniger Ringe</translation>
    </message>
    <message>
        <source>Between &amp;Voxels</source>
        <translation>Zwischen &amp;Voxeln</translation>
    </message>
    <message>
        <source>Values between voxels</source>
        <translation>Werte zwischen Voxeln</translation>
    </message>
    <message>
        <source>Keep &amp;Hues of Highlights</source>
        <translation>Farbtöne &amp;heller Stellen erhalten</translation>
    </message>
    <message>
        <source>What is too bright for the screen bleaches in its own hue; without it, contrast is higher. Not of projections</source>
        <translation>Was zu hell für den Bildschirm ist, verblasst in seinem eigenen Farbton; ohne dies ist der Kontrast höher. Nicht bei Projektionen</translation>
    </message>
    <message>
        <source>Hues of highlights</source>
        <translation>Farbtöne heller Stellen</translation>
    </message>
    <message>
        <source>Reset &amp;Window</source>
        <translation>&amp;Fensterung zurücksetzen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
    <message>
        <source>Of the values: that of the series</source>
        <translation>Der Werte: die der Serie</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MainWindow</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>&amp;About Macula</source>
        <translation>&amp;Über Macula</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Be&amp;enden</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>Patient and study over the picture</source>
        <translation>Patient und Studie über dem Bild</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>Lights</source>
        <translation>Beleuchtung</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Transfer Function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
    <message>
        <source>Movie</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>Segmentations</source>
        <translation>Segmentierungen</translation>
    </message>
    <message>
        <source>Headset</source>
        <translation>Headset</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>Curved Plane</source>
        <translation>Gekrümmte Ebene</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Dose</source>
        <translation>Dosis</translation>
    </message>
    <message>
        <source>Pane&amp;ls</source>
        <translation>Fel&amp;der</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ManifestsController</name>
    <message>
        <source>Fetching was cancelled. What came is kept; opening the manifest again goes on from there.</source>
        <translation>Das Abrufen wurde abgebrochen. Was gekommen ist, bleibt erhalten; wird das Manifest noch einmal geöffnet, geht es dort weiter.</translation>
    </message>
    <message>
        <source>Fetching what the manifest names</source>
        <translation>Was das Manifest nennt, wird abgerufen</translation>
    </message>
    <message numerus="yes">
        <source>The manifest names %n studies, which were all fetched. The first one is shown; macula pacs fetched lists them all.</source>
        <translation>
            <numerusform>Das Manifest nennt %n Studie, die abgerufen wurde. Sie wird gezeigt; macula pacs fetched listet sie auf.</numerusform>
            <numerusform>Das Manifest nennt %n Studien, die alle abgerufen wurden. Die erste wird gezeigt; macula pacs fetched listet alle auf.</numerusform>
        </translation>
    </message>
    <message>
        <source>What the manifest names was fetched. Another study was opened meanwhile; open the manifest again to show it.</source>
        <translation>Was das Manifest nennt, wurde abgerufen. Inzwischen wurde eine andere Studie geöffnet; öffnen Sie das Manifest noch einmal, um das Abgerufene zu zeigen.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MatterFields</name>
    <message>
        <source> per mm</source>
        <translation> je mm</translation>
    </message>
    <message>
        <source> %1/mm</source>
        <translation> %1/mm</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MeasurementList</name>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Click: the slices go there. F2: its label. Delete: removes it</source>
        <translation>Klick: Die Schichten gehen dorthin. F2: die Beschriftung. Entf: entfernt sie</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>%1, image %2</source>
        <translation>%1, Bild %2</translation>
    </message>
    <message>
        <source>Go to a Measurement</source>
        <translation>Zu einer Messung</translation>
    </message>
    <message>
        <source>Measurement removed</source>
        <translation>Messung entfernt</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MeasurementsController</name>
    <message>
        <source>Save &amp;Measurements…</source>
        <translation>&amp;Messungen speichern…</translation>
    </message>
    <message>
        <source>As a table (CSV) or JSON, in mm, degrees and the unit of the study</source>
        <translation>Als Tabelle (CSV) oder JSON, in mm, Grad und der Einheit der Studie</translation>
    </message>
    <message>
        <source>Remove All &amp;Measurements</source>
        <translation>Alle &amp;Messungen entfernen</translation>
    </message>
    <message>
        <source>Remove measurements</source>
        <translation>Messungen entfernen</translation>
    </message>
    <message>
        <source>There are no measurements to save.</source>
        <translation>Es gibt keine Messungen zu speichern.</translation>
    </message>
    <message>
        <source>Measure something on a slice first.</source>
        <translation>Messen Sie zuerst etwas auf einer Schicht.</translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation>Messungen speichern</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json)</source>
        <translation>Tabelle (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>The measurements are written to %1.</source>
        <translation>Die Messungen sind in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Save Measurements as D&amp;ICOM…</source>
        <translation>Messungen als DICOM-Ob&amp;jekt speichern…</translation>
    </message>
    <message>
        <source>As a structured report, which archives keep and other programs show over the images</source>
        <translation>Als Structured Report, den Archive aufbewahren und andere Programme über den Bildern zeigen</translation>
    </message>
    <message>
        <source>A report of measurements refers to DICOM images, and none are open.</source>
        <translation>Ein Messbericht bezieht sich auf DICOM-Bilder, und keine sind offen.</translation>
    </message>
    <message>
        <source>Save the measurements as a table.</source>
        <translation>Speichern Sie die Messungen als Tabelle.</translation>
    </message>
    <message>
        <source>Measurements are still being written.</source>
        <translation>Messungen werden noch geschrieben.</translation>
    </message>
    <message>
        <source>Save Measurements as DICOM</source>
        <translation>Messungen als DICOM-Objekt speichern</translation>
    </message>
    <message>
        <source>A structured report for the archive: lengths, angles, areas and values with their places in the images. It says that nobody has verified it, and not who measured.</source>
        <translation>Ein Structured Report für das Archiv: Längen, Winkel, Flächen und Werte mit ihrer Lage in den Bildern. Darin steht, dass ihn niemand verifiziert hat; wer gemessen hat, steht nicht darin.</translation>
    </message>
    <message>
        <source>Nothing of the patient is written, no label, and all UIDs are other ones.</source>
        <translation>Vom Patienten wird nichts geschrieben, auch keine Beschriftung, und alle UIDs sind andere.</translation>
    </message>
    <message>
        <source>DICOM files (*.dcm)</source>
        <translation>DICOM-Dateien (*.dcm)</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MessageBar</name>
    <message>
        <source>Dismiss this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ModelExport</name>
    <message>
        <source>The model is written to %1.</source>
        <translation>Das Modell ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source> It holds pictures of the study.</source>
        <translation> Es enthält Bilder der Studie.</translation>
    </message>
    <message>
        <source>Only Cinematic and Clear in lights that stay in place have one. Wait until the status line says that it learns.</source>
        <translation>Nur Cinematic und Klar in einer Beleuchtung, die an ihrem Ort bleibt, haben eines. Warten Sie, bis die Statuszeile sagt, dass es lernt.</translation>
    </message>
    <message numerus="yes">
        <source> %Ln of its Gaussians have numbers that this format cannot hold; they were limited.</source>
        <translation>
            <numerusform> %Ln seiner Gaußfunktionen hat Zahlen, die dieses Format nicht fassen kann; sie wurden begrenzt.</numerusform>
            <numerusform> %Ln seiner Gaußfunktionen haben Zahlen, die dieses Format nicht fassen kann; sie wurden begrenzt.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no model of this picture.</source>
        <translation>Von diesem Bild gibt es kein Modell.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ModelsController</name>
    <message>
        <source>glTF, for other programs (*.glb)</source>
        <translation>glTF, für andere Programme (*.glb)</translation>
    </message>
    <message>
        <source>PLY, for other programs (*.ply)</source>
        <translation>PLY, für andere Programme (*.ply)</translation>
    </message>
    <message>
        <source>PLY, exact, in linear light (*.ply)</source>
        <translation>PLY, genau, in linearem Licht (*.ply)</translation>
    </message>
    <message>
        <source>SPZ, small, for other programs (*.spz)</source>
        <translation>SPZ, klein, für andere Programme (*.spz)</translation>
    </message>
    <message>
        <source>Training that can go on, with its pictures (*.macula)</source>
        <translation>Training, das weitergehen kann, mit seinen Bildern (*.macula)</translation>
    </message>
    <message>
        <source>Writing the model</source>
        <translation>Das Modell wird gespeichert</translation>
    </message>
    <message>
        <source>Save Mo&amp;del…</source>
        <translation>Mode&amp;ll speichern…</translation>
    </message>
    <message>
        <source>The preview as a model in mm of the patient (3D Gaussians), for this and other programs</source>
        <translation>Die Vorschau als Modell in mm des Patienten (3D-Gaußfunktionen), für dieses und andere Programme</translation>
    </message>
    <message>
        <source>A model is still being written.</source>
        <translation>Ein Modell wird noch geschrieben.</translation>
    </message>
    <message>
        <source>There is no model to save yet.</source>
        <translation>Es gibt noch kein Modell zu speichern.</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>Modell speichern</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MovieExport</name>
    <message>
        <source>, %1 s left</source>
        <translation>, noch %1 s</translation>
    </message>
    <message>
        <source>, %1 min left</source>
        <translation>, noch %1 min</translation>
    </message>
    <message>
        <source>Encoding the video</source>
        <translation>Das Video wird kodiert</translation>
    </message>
    <message>
        <source>The video is %1.</source>
        <translation>Das Video ist %1.</translation>
    </message>
    <message>
        <source>The encoder made no video of them: take another program for that.</source>
        <translation>Der Encoder hat daraus kein Video gemacht: verwenden Sie dafür ein anderes Programm.</translation>
    </message>
    <message>
        <source>The video was stopped.</source>
        <translation>Das Video wurde angehalten.</translation>
    </message>
    <message>
        <source>No video was made of them: there is no encoder. Install ffmpeg, and draw again.</source>
        <translation>Daraus wurde kein Video gemacht: es gibt keinen Encoder. Installieren Sie ffmpeg, und zeichnen Sie noch einmal.</translation>
    </message>
    <message>
        <source>No video was made of them: %1 is there already.</source>
        <translation>Daraus wurde kein Video gemacht: %1 gibt es schon.</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pictures are in %1.</source>
        <translation>
            <numerusform>%Ln Bild ist in %1.</numerusform>
            <numerusform>%Ln Bilder sind in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::MoviePanel</name>
    <message>
        <source>%1, %2 to %3%4</source>
        <translation>%1, %2 bis %3%4</translation>
    </message>
    <message>
        <source>&amp;Draw Movie…</source>
        <translation>Film &amp;zeichnen…</translation>
    </message>
    <message>
        <source>Draw all pictures to a folder, while the window goes on</source>
        <translation>Alle Bilder in einen Ordner zeichnen, während das Fenster weitergeht</translation>
    </message>
    <message>
        <source>How the camera goes</source>
        <translation>Wie die Kamera geht</translation>
    </message>
    <message>
        <source>Around the patient from here, or along views that are added</source>
        <translation>Von hier um den Patienten herum oder entlang hinzugefügter Ansichten</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Umrundung</translation>
    </message>
    <message>
        <source>Along views</source>
        <translation>Entlang von Ansichten</translation>
    </message>
    <message>
        <source>Degrees around the patient</source>
        <translation>Grad um den Patienten</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Seconds</source>
        <translation>Sekunden</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source> /s</source>
        <translation> /s</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>Breite in Pixeln</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>Höhe in Pixeln</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>More samples per pixel: less noise, and more time</source>
        <translation>Mehr Abtastungen je Pixel: weniger Rauschen und mehr Zeit</translation>
    </message>
    <message>
        <source>Sides of the &amp;patient</source>
        <translation>Seiten des &amp;Patienten</translation>
    </message>
    <message>
        <source>Letters at the edges of each picture</source>
        <translation>Buchstaben an den Rändern jedes Bildes</translation>
    </message>
    <message>
        <source>&amp;Name patient and study</source>
        <translation>Patient und Studie &amp;nennen</translation>
    </message>
    <message>
        <source>Over each picture, as in the window. Without it nobody is named; a face can still be seen</source>
        <translation>Über jedem Bild, wie im Fenster. Ohne das wird niemand genannt; ein Gesicht ist trotzdem zu erkennen</translation>
    </message>
    <message>
        <source>&amp;Video of them</source>
        <translation>&amp;Video daraus</translation>
    </message>
    <message>
        <source>An MP4 file beside them, by ffmpeg if it is installed</source>
        <translation>Eine MP4-Datei daneben, mit ffmpeg, wenn es installiert ist</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>De&amp;grees</source>
        <translation>&amp;Grad</translation>
    </message>
    <message>
        <source>&amp;Seconds</source>
        <translation>&amp;Sekunden</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>Views of the way</source>
        <translation>Ansichten der Kamerafahrt</translation>
    </message>
    <message>
        <source>The camera goes smoothly from each to the next</source>
        <translation>Die Kamera geht gleitend von jeder zur nächsten</translation>
    </message>
    <message>
        <source>&amp;Add View</source>
        <translation>&amp;Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>What is looked at now, 2 s after the view before</source>
        <translation>Was jetzt zu sehen ist, 2 s nach der Ansicht davor</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Leave out the view that is chosen</source>
        <translation>Die gewählte Ansicht weglassen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Öffnen…</translation>
    </message>
    <message>
        <source>A way from a file, as of macula hybrid --path</source>
        <translation>Eine Kamerafahrt aus einer Datei, wie von macula hybrid --path</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>The way to a file, for macula hybrid --path</source>
        <translation>Die Kamerafahrt in eine Datei, für macula hybrid --path</translation>
    </message>
    <message>
        <source>View %1, at %L2 s</source>
        <translation>Ansicht %1, bei %L2 s</translation>
    </message>
    <message numerus="yes">
        <source>%Ln pictures</source>
        <translation>
            <numerusform>%Ln Bild</numerusform>
            <numerusform>%Ln Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>This machine has no encoder: install ffmpeg for a video. Pictures are drawn to the folder all the same.</source>
        <translation>Dieser Rechner hat keinen Encoder: für ein Video installieren Sie ffmpeg. Die Bilder werden trotzdem in den Ordner gezeichnet.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::MoviesController</name>
    <message>
        <source>Drawing the movie</source>
        <translation>Der Film wird gezeichnet</translation>
    </message>
    <message>
        <source>Save Mo&amp;vie…</source>
        <translation>F&amp;ilm speichern…</translation>
    </message>
    <message>
        <source>A turntable or a way of the camera as pictures, and as a video</source>
        <translation>Eine Umrundung oder Kamerafahrt als Bilder und als Video</translation>
    </message>
    <message>
        <source>A movie is still being drawn.</source>
        <translation>Ein Film wird noch gezeichnet.</translation>
    </message>
    <message>
        <source>There is nothing to draw yet.</source>
        <translation>Es gibt noch nichts zu zeichnen.</translation>
    </message>
    <message>
        <source>Choose a folder for the pictures</source>
        <translation>Ordner für die Bilder wählen</translation>
    </message>
    <message>
        <source>Open a way of the camera</source>
        <translation>Kamerafahrt öffnen</translation>
    </message>
    <message>
        <source>Ways (*.json)</source>
        <translation>Kamerafahrten (*.json)</translation>
    </message>
    <message>
        <source>Save the way of the camera</source>
        <translation>Kamerafahrt speichern</translation>
    </message>
    <message>
        <source>The way is written to %1. macula hybrid draws it with --path %1.</source>
        <translation>Die Kamerafahrt ist in %1 gespeichert. macula hybrid zeichnet sie mit --path %1.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::NamedClips</name>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Clips of this study</source>
        <translation>Beschnitte dieser Studie</translation>
    </message>
    <message>
        <source>Name of a clip</source>
        <translation>Name eines Beschnitts</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Type a name first.</source>
        <translation>Geben Sie zuerst einen Namen ein.</translation>
    </message>
    <message>
        <source>There are %1 clips, and no more are possible. Delete one first.</source>
        <translation>Es gibt %1 Beschnitte, und mehr sind nicht möglich. Löschen Sie zuerst einen.</translation>
    </message>
    <message>
        <source>Save clip</source>
        <translation>Beschnitt speichern</translation>
    </message>
    <message>
        <source>Clip</source>
        <translation>Beschnitt</translation>
    </message>
    <message>
        <source>Another clip has that name. Take another one.</source>
        <translation>Ein anderer Beschnitt heißt so. Nehmen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Rename clip</source>
        <translation>Beschnitt umbenennen</translation>
    </message>
    <message>
        <source>Delete clip</source>
        <translation>Beschnitt löschen</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>Choose a clip of the list first.</source>
        <translation>Wählen Sie zuerst einen Beschnitt aus der Liste.</translation>
    </message>
    <message>
        <source>Double click shows one again</source>
        <translation>Doppelklick zeigt einen wieder</translation>
    </message>
    <message>
        <source>What the clip is called; it is kept with the study</source>
        <translation>Wie der Beschnitt heißt; er wird mit der Studie aufbewahrt</translation>
    </message>
    <message>
        <source>Keeps what is clipped and cut now under that name</source>
        <translation>Behält unter diesem Namen, was jetzt beschnitten und geschnitten ist</translation>
    </message>
    <message>
        <source>Clips as it was when that was saved</source>
        <translation>Beschneidet, wie es beim Speichern war</translation>
    </message>
    <message>
        <source>Gives the chosen clip the name that is typed</source>
        <translation>Gibt dem gewählten Beschnitt den eingegebenen Namen</translation>
    </message>
    <message>
        <source>Deletes the chosen clip from the list; what is shown stays</source>
        <translation>Löscht den gewählten Beschnitt aus der Liste; das Gezeigte bleibt</translation>
    </message>
</context>
<context>
    <name>macula::viewer::Notifications</name>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::OpeningController</name>
    <message>
        <source>Opening</source>
        <translation>Wird geöffnet</translation>
    </message>
    <message>
        <source>Only one folder or file can be opened at a time.</source>
        <translation>Es kann nur ein Ordner oder eine Datei auf einmal geöffnet werden.</translation>
    </message>
    <message>
        <source>Drop one of them, or the folder that holds them all.</source>
        <translation>Legen Sie einen davon ab, oder den Ordner, in dem alle sind.</translation>
    </message>
    <message>
        <source>&amp;Open Folder…</source>
        <translation>&amp;Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open the best volume in a folder of DICOM files</source>
        <translation>Das beste Volumen eines Ordners mit DICOM-Dateien öffnen</translation>
    </message>
    <message>
        <source>Open &amp;File…</source>
        <translation>&amp;Datei öffnen…</translation>
    </message>
    <message>
        <source>Open &amp;Phantom</source>
        <translation>&amp;Phantom öffnen</translation>
    </message>
    <message>
        <source>Open the built-in phantom study</source>
        <translation>Die eingebaute Phantomstudie öffnen</translation>
    </message>
    <message>
        <source>Open a folder of DICOM files</source>
        <translation>Ordner mit DICOM-Dateien öffnen</translation>
    </message>
    <message>
        <source>What is on screen is still of the study that was open before.</source>
        <translation>Auf dem Bildschirm ist noch die Studie, die vorher offen war.</translation>
    </message>
    <message>
        <source>Open the series of an image, a DICOMDIR, a ZIP, tar or ISO 9660 file with studies, or a NIfTI, NRRD or MetaImage file</source>
        <translation>Die Serie eines Bildes, ein DICOMDIR, eine ZIP-, tar- oder ISO-9660-Datei mit Studien oder eine NIfTI-, NRRD- oder MetaImage-Datei öffnen</translation>
    </message>
    <message>
        <source>Open an image, a volume, or an archive of studies</source>
        <translation>Bild, Volumen oder Archiv mit Studien öffnen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::OwnWindowList</name>
    <message>
        <source>Windows of your own that were kept cannot be read.</source>
        <translation>Behaltene eigene Fensterungen können nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The next one that you keep takes their place.</source>
        <translation>Die nächste, die Sie behalten, tritt an ihre Stelle.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PanelsController</name>
    <message>
        <source>Panels that share this place</source>
        <translation>Bereiche, die sich diesen Platz teilen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PanesController</name>
    <message>
        <source>Panes</source>
        <translation>Bildfelder</translation>
    </message>
    <message>
        <source>Type a &amp;Window…</source>
        <translation>&amp;Fensterung eingeben…</translation>
    </message>
    <message>
        <source>Width and level of the slices as numbers</source>
        <translation>Weite und Lage der Schichten als Zahlen</translation>
    </message>
    <message>
        <source>Save the picture of the slice</source>
        <translation>Das Bild der Schicht speichern</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Bild (*.png)</translation>
    </message>
    <message>
        <source>The picture is written to %1.</source>
        <translation>Das Bild ist in %1 geschrieben.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PatientMmBox</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PhaseBar</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Which phase the slices show</source>
        <translation>Welche Phase die Schichten zeigen</translation>
    </message>
    <message>
        <source>Phases a second</source>
        <translation>Phasen je Sekunde</translation>
    </message>
    <message>
        <source>How many phases are shown in a second</source>
        <translation>Wie viele Phasen in einer Sekunde gezeigt werden</translation>
    </message>
    <message>
        <source>Open This Phase</source>
        <translation>Diese Phase öffnen</translation>
    </message>
    <message>
        <source>Curve over Phases…</source>
        <translation>Verlauf über die Phasen…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>The mean within each ellipse, in each phase</source>
        <translation>Der Mittelwert in jeder Ellipse, in jeder Phase</translation>
    </message>
    <message>
        <source>Phase on slices</source>
        <translation>Phase auf Schichten</translation>
    </message>
    <message>
        <source>Play the phases, or stop</source>
        <translation>Die Phasen abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Measurements and changes are then those of this phase, and 3D shows it too</source>
        <translation>Messungen und Änderungen gehören dann zu dieser Phase, und auch 3D zeigt sie</translation>
    </message>
    <message>
        <source>3D Too</source>
        <translation>Auch 3D</translation>
    </message>
    <message>
        <source>3D too</source>
        <translation>Auch 3D</translation>
    </message>
    <message>
        <source>3D shows the phase of the slices, and plays it</source>
        <translation>3D zeigt die Phase der Schnitte und spielt sie ab</translation>
    </message>
    <message>
        <source>Learn Phases</source>
        <translation>Phasen lernen</translation>
    </message>
    <message>
        <source>Learn phases</source>
        <translation>Phasen lernen</translation>
    </message>
    <message>
        <source>While the 3D picture rests, a preview of each phase is learnt and stored; learnt phases play without being traced</source>
        <translation>Solange das 3D-Bild ruht, lernt Macula von jeder Phase eine Vorschau und speichert sie; gelernte Phasen spielen, ohne dass Strahlen verfolgt werden</translation>
    </message>
    <message>
        <source>Values or difference</source>
        <translation>Werte oder Differenz</translation>
    </message>
    <message>
        <source>Whether slices show the values of the phase, or how they differ from those of another phase</source>
        <translation>Ob Schnitte die Werte der Phase zeigen oder deren Unterschied zu einer anderen Phase</translation>
    </message>
    <message>
        <source>Largest difference with a colour of its own</source>
        <translation>Größte Differenz mit eigener Farbe</translation>
    </message>
    <message>
        <source>Differences beyond this have the same colour</source>
        <translation>Größere Differenzen haben dieselbe Farbe</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Difference to phase %1</source>
        <translation>Differenz zu Phase %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PhasesController</name>
    <message>
        <source>Phase %1 of %2, %3</source>
        <translation>Phase %1 von %2, %3</translation>
    </message>
    <message>
        <source>%1; 3D and saved values: phase %2</source>
        <translation>%1; 3D und gespeicherte Werte: Phase %2</translation>
    </message>
    <message>
        <source>Memory is not enough for all phases</source>
        <translation>Der Speicher reicht nicht für alle Phasen</translation>
    </message>
    <message>
        <source>%1 of %2 decoded</source>
        <translation>%1 von %2 dekodiert</translation>
    </message>
    <message>
        <source>%1 is being decoded</source>
        <translation>%1 wird dekodiert</translation>
    </message>
    <message>
        <source>%1; saved values: phase %2</source>
        <translation>%1; gespeicherte Werte: Phase %2</translation>
    </message>
    <message>
        <source>Difference of values: phase %1 − phase %2 (of %3); saved values: phase %4</source>
        <translation>Differenz der Werte: Phase %1 − Phase %2 (von %3); gespeicherte Werte: Phase %4</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PhasesIn3d</name>
    <message>
        <source>%1; saved values: phase %2</source>
        <translation>%1; gespeicherte Werte: Phase %2</translation>
    </message>
    <message>
        <source>Colours of segments are of phase %1, and not shown here</source>
        <translation>Farben der Segmente gehören zu Phase %1 und werden hier nicht gezeigt</translation>
    </message>
    <message>
        <source>Voxels are hidden where phase %1 has them hidden</source>
        <translation>Voxel sind dort verborgen, wo Phase %1 sie verbirgt</translation>
    </message>
    <message>
        <source>The second volume is placed for phase %1</source>
        <translation>Das zweite Volumen ist für Phase %1 platziert</translation>
    </message>
    <message>
        <source>All phases are learnt for 3D</source>
        <translation>Alle Phasen sind für 3D gelernt</translation>
    </message>
    <message>
        <source>%1 of %2 phases learnt for 3D</source>
        <translation>%1 von %2 Phasen für 3D gelernt</translation>
    </message>
    <message>
        <source>%1; the device has no memory for more</source>
        <translation>%1; der Grafikspeicher reicht nicht für weitere</translation>
    </message>
    <message>
        <source>%1; phase %2, step %3</source>
        <translation>%1; Phase %2, Schritt %3</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PickController</name>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Measure a &amp;Distance in 3D</source>
        <translation>Eine &amp;Strecke in 3D messen</translation>
    </message>
    <message>
        <source>Double-click two places of what is seen in 3D: the straight line between them, in mm</source>
        <translation>Zwei Stellen dessen doppelklicken, was in 3D zu sehen ist: die gerade Linie dazwischen, in mm</translation>
    </message>
    <message>
        <source>Double-click both ends of the distance in 3D.</source>
        <translation>Doppelklicken Sie in 3D beide Enden der Strecke.</translation>
    </message>
    <message>
        <source>Turn the picture as you like, and double-click the other end.</source>
        <translation>Drehen Sie das Bild, wie Sie möchten, und doppelklicken Sie das andere Ende.</translation>
    </message>
    <message>
        <source>%1 in a straight line. It is in the list of measurements (Ctrl+Shift+M).</source>
        <translation>%1 in gerader Linie. Sie steht in der Liste der Messungen (Strg+Umschalt+M).</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PictureCurtain</name>
    <message>
        <source>Both pictures</source>
        <translation>Beide Bilder</translation>
    </message>
    <message>
        <source>Drag the line between the two presets</source>
        <translation>Die Linie zwischen den beiden Voreinstellungen ziehen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PictureDialog</name>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>&amp;Without patient and study</source>
        <translation>&amp;Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>As on screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Twice the screen</source>
        <translation>Zweimal der Bildschirm</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>Full HD</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Another size</source>
        <translation>Andere Größe</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>More samples per pixel: less noise, and more time</source>
        <translation>Mehr Abtastungen je Pixel: weniger Rauschen und mehr Zeit</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Linse</translation>
    </message>
    <message>
        <source>Diameter in mm: what the middle of the picture shows is sharp, what is nearer or farther is blurred. Not of ray casts and projections</source>
        <translation>Durchmesser in mm: Scharf ist, was die Bildmitte zeigt; was näher oder ferner ist, wird unscharf. Nicht bei Volumen-Rendering und Projektionen</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>What lies behind the nearest matter fades into the background, to 37 % over so many mm. Not of projections</source>
        <translation>Was hinter der nächsten Materie liegt, verblasst in den Hintergrund, auf 37 % in so vielen mm. Nicht bei Projektionen</translation>
    </message>
    <message>
        <source>&amp;Lens</source>
        <translation>&amp;Linse</translation>
    </message>
    <message>
        <source>&amp;Fog</source>
        <translation>&amp;Nebel</translation>
    </message>
    <message>
        <source>Of DICOM files: nothing of the patient is written, and all UIDs are new. Other files never name anybody. A face can still be seen.</source>
        <translation>Bei DICOM-Dateien: vom Patienten wird nichts geschrieben, und alle UIDs sind neu. Andere Dateien nennen nie jemanden. Ein Gesicht ist trotzdem zu erkennen.</translation>
    </message>
    <message>
        <source>&amp;Choose File…</source>
        <translation>&amp;Datei wählen…</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Höhe</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>A usual size in pixels; any other below</source>
        <translation>Eine übliche Größe in Pixeln; jede andere darunter</translation>
    </message>
    <message>
        <source>Choose where the picture is saved; then it is drawn</source>
        <translation>Wählen, wo das Bild gespeichert wird; dann wird es gezeichnet</translation>
    </message>
    <message>
        <source>Save no picture</source>
        <translation>Kein Bild speichern</translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n Abtastung</numerusform>
            <numerusform>%n Abtastungen</numerusform>
        </translation>
    </message>
    <message>
        <source>With &amp;cube, scale and letters</source>
        <translation>Mit &amp;Würfel, Maßstab und Buchstaben</translation>
    </message>
    <message>
        <source>From where the patient is seen, and how many mm or cm something is long, over the picture. Pictures of light (EXR) have none. Nobody is named</source>
        <translation>Von wo der Patient gesehen wird, und wie viele mm oder cm etwas lang ist, über dem Bild. Bilder aus Licht (EXR) haben keine. Niemand wird genannt</translation>
    </message>
    <message>
        <source>The view in 3D is drawn, which is not shown now. Slices are not saved as pictures.</source>
        <translation>Gezeichnet wird die Ansicht in 3D, die gerade nicht gezeigt wird. Schichten werden nicht als Bilder gespeichert.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PicturesController</name>
    <message>
        <source>Drawing the picture</source>
        <translation>Das Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>The picture is written to %1.</source>
        <translation>Das Bild ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation>&amp;Bild speichern…</translation>
    </message>
    <message>
        <source>Draw what is seen in 3D at any size and quality, without names</source>
        <translation>Zeichnet, was in 3D zu sehen ist, in jeder Größe und Qualität, ohne Namen</translation>
    </message>
    <message>
        <source>A picture is still being drawn.</source>
        <translation>Ein Bild wird noch gezeichnet.</translation>
    </message>
    <message>
        <source>There is no picture to save yet.</source>
        <translation>Es gibt noch kein Bild zu speichern.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png);;Linear light and depth (*.exr);;DICOM Secondary Capture (*.dcm)</source>
        <translation>Bilder (*.png);;Lineares Licht und Tiefe (*.exr);;DICOM Secondary Capture (*.dcm)</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PlanarBar</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play the frames of the image in a loop; Space</source>
        <translation>Die Einzelbilder in einer Schleife abspielen; Leertaste</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How fast the frames are played</source>
        <translation>Wie schnell die Einzelbilder abgespielt werden</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Which image is shown; the wheel steps through them</source>
        <translation>Welches Bild gezeigt wird; das Rad geht durch alle</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>The windows and tables of the file</source>
        <translation>Die Fenster und Tabellen der Datei</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Invertieren</translation>
    </message>
    <message>
        <source>Show bright values dark; I</source>
        <translation>Helle Werte dunkel zeigen; I</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Turn the picture by 90° clockwise; R</source>
        <translation>Das Bild um 90° im Uhrzeigersinn drehen; R</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Exchange left and right; M</source>
        <translation>Links und rechts vertauschen; M</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the whole picture; F</source>
        <translation>Das ganze Bild zeigen; F</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Back to the volume that is open; Esc</source>
        <translation>Zurück zum geöffneten Volumen; Esc</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Presentation state</source>
        <translation>Presentation State</translation>
    </message>
    <message>
        <source>How somebody left the images for others: windows, marks and texts</source>
        <translation>Wie jemand die Bilder für andere hinterlassen hat: Fenster, Markierungen und Texte</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Measure on the image: distance, angle, ellipse, Cobb angle; overlays</source>
        <translation>Im Bild messen: Strecke, Winkel, Ellipse, Cobb-Winkel; Overlays</translation>
    </message>
    <message>
        <source>Window: drag</source>
        <translation>Fenster: ziehen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Strecke</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>Ellipse</translation>
    </message>
    <message>
        <source>Cobb angle: two lines</source>
        <translation>Cobb-Winkel: zwei Linien</translation>
    </message>
    <message>
        <source>Copy Measurements</source>
        <translation>Messungen kopieren</translation>
    </message>
    <message>
        <source>Save Measurements…</source>
        <translation>Messungen sichern …</translation>
    </message>
    <message>
        <source>Remove All Measurements</source>
        <translation>Alle Messungen entfernen</translation>
    </message>
    <message>
        <source>Overlays of the file</source>
        <translation>Overlays der Datei</translation>
    </message>
    <message>
        <source>Boxes</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>Several images side by side, and hanging protocols</source>
        <translation>Mehrere Bilder nebeneinander, und Hängeprotokolle</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PlanarController</name>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PlanarMeasuring</name>
    <message>
        <source>Remove measurement</source>
        <translation>Messung entfernt</translation>
    </message>
    <message>
        <source>Remove measurements</source>
        <translation>Messungen entfernt</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
    <message>
        <source>Measurement</source>
        <translation>Messung</translation>
    </message>
    <message>
        <source>Move measurement</source>
        <translation>Messung verschoben</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PlanarPane</name>
    <message>
        <source>lossily compressed</source>
        <translation>verlustbehaftet komprimiert</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PlanarPresenting</name>
    <message>
        <source>As stored</source>
        <translation>Wie gespeichert</translation>
    </message>
    <message>
        <source>Presentation state %1</source>
        <translation>Presentation State %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PlanarSaving</name>
    <message>
        <source>The measurements are written to %1.</source>
        <translation>Die Messungen sind in %1 geschrieben.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild sichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>The picture is written to %1, without names.</source>
        <translation>Das Bild ist in %1 geschrieben, ohne Namen.</translation>
    </message>
    <message>
        <source>There are no measurements to save.</source>
        <translation>Es gibt keine Messungen zu sichern.</translation>
    </message>
    <message>
        <source>Measure something on an image first: D draws a distance.</source>
        <translation>Messen Sie zuerst etwas in einem Bild: D zeichnet eine Strecke.</translation>
    </message>
    <message>
        <source>Save the measurements</source>
        <translation>Messungen sichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PlanesController</name>
    <message>
        <source>Writing planes</source>
        <translation>Ebenen werden geschrieben</translation>
    </message>
    <message>
        <source>Save a &amp;Batch of Planes…</source>
        <translation>E&amp;benenreihe speichern …</translation>
    </message>
    <message>
        <source>Planes like that of the slice pane with the focus, or about a line, as a DICOM series that keeps its place in the patient</source>
        <translation>Ebenen wie die des aktiven Schichtfeldes, oder um eine Linie, als DICOM-Serie, die ihre Lage im Patienten behält</translation>
    </message>
    <message>
        <source>A batch of planes is still being written.</source>
        <translation>Eine Reihe von Ebenen wird noch geschrieben.</translation>
    </message>
    <message>
        <source>No slice is shown whose plane could be taken.</source>
        <translation>Es ist keine Schicht zu sehen, deren Ebene genommen werden könnte.</translation>
    </message>
    <message>
        <source>Open a study, and show slices: F5.</source>
        <translation>Öffnen Sie eine Studie, und zeigen Sie Schichten: F5.</translation>
    </message>
    <message>
        <source>Choose an empty folder for the planes</source>
        <translation>Leeren Ordner für die Ebenen wählen</translation>
    </message>
    <message numerus="yes">
        <source>%n planes are written to %1.</source>
        <translation>
            <numerusform>%n Ebene ist nach %1 geschrieben.</numerusform>
            <numerusform>%n Ebenen sind nach %1 geschrieben.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::PlanesDialog</name>
    <message>
        <source>None: each plane alone</source>
        <translation>Keine: jede Ebene für sich</translation>
    </message>
    <message>
        <source>Mean over %1 mm, as in the panes</source>
        <translation>Mittel über %1 mm, wie in den Feldern</translation>
    </message>
    <message>
        <source>Maximum over %1 mm, as in the panes</source>
        <translation>Maximum über %1 mm, wie in den Feldern</translation>
    </message>
    <message>
        <source>Minimum over %1 mm, as in the panes</source>
        <translation>Minimum über %1 mm, wie in den Feldern</translation>
    </message>
    <message>
        <source>Distance of the first plane from the one in the pane, along its normal</source>
        <translation>Abstand der ersten Ebene von der im Feld, entlang ihrer Normalen</translation>
    </message>
    <message>
        <source>Distance of the last plane</source>
        <translation>Abstand der letzten Ebene</translation>
    </message>
    <message>
        <source>Distance from plane to plane</source>
        <translation>Abstand von Ebene zu Ebene</translation>
    </message>
    <message>
        <source>&amp;Without patient and study</source>
        <translation>&amp;Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Save a Batch of Planes</source>
        <translation>Ebenenreihe speichern</translation>
    </message>
    <message>
        <source>Planes</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>How the planes lie to each other</source>
        <translation>Wie die Ebenen zueinander liegen</translation>
    </message>
    <message>
        <source>Parallel to this plane</source>
        <translation>Parallel zu dieser Ebene</translation>
    </message>
    <message>
        <source>About the line through the cross-hair, across this plane</source>
        <translation>Um die Linie durch das Fadenkreuz, quer zu dieser Ebene</translation>
    </message>
    <message>
        <source>About the curve, near the cross-hair</source>
        <translation>Um die Kurve, beim Fadenkreuz</translation>
    </message>
    <message>
        <source>Number of planes</source>
        <translation>Zahl der Ebenen</translation>
    </message>
    <message>
        <source>So many in half a turn</source>
        <translation>So viele in einer halben Drehung</translation>
    </message>
    <message>
        <source>Without patient and study</source>
        <translation>Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Nothing of the patient is written, and all UIDs are other ones. A face can still be seen.</source>
        <translation>Vom Patienten wird nichts geschrieben, und alle UIDs sind andere. Ein Gesicht kann trotzdem zu sehen sein.</translation>
    </message>
    <message>
        <source>&amp;Choose Folder…</source>
        <translation>&amp;Ordner wählen …</translation>
    </message>
    <message>
        <source>Choose an empty folder for the images; then they are written</source>
        <translation>Wählen Sie einen leeren Ordner für die Bilder; dann werden sie geschrieben</translation>
    </message>
    <message>
        <source>&amp;Planes</source>
        <translation>&amp;Ebenen</translation>
    </message>
    <message>
        <source>&amp;From</source>
        <translation>&amp;Von</translation>
    </message>
    <message>
        <source>&amp;To</source>
        <translation>&amp;Bis</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>&amp;Schritt</translation>
    </message>
    <message>
        <source>&amp;Number</source>
        <translation>&amp;Anzahl</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Slab</translation>
    </message>
    <message numerus="yes">
        <source>%n images of %1 × %2 pixels of %3 mm, over the area that the pane shows.</source>
        <translation>
            <numerusform>%n Bild von %1 × %2 Pixeln von %3 mm, über die Fläche, die das Feld zeigt.</numerusform>
            <numerusform>%n Bilder von %1 × %2 Pixeln von %3 mm, über die Fläche, die das Feld zeigt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::PointFields</name>
    <message>
        <source>Value of the selected point</source>
        <translation>Wert des gewählten Punkts</translation>
    </message>
    <message>
        <source>Opacity of the selected point, 0 to 1</source>
        <translation>Deckkraft des gewählten Punkts, 0 bis 1</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Colour of the selected point</source>
        <translation>Farbe des gewählten Punkts</translation>
    </message>
    <message>
        <source>Choose the colour of the selected colour point (sRGB)</source>
        <translation>Die Farbe des gewählten Farbpunkts wählen (sRGB)</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Value of the selected point, in the scanner&apos;s own numbers</source>
        <translation>Wert des gewählten Punkts, in Zahlen des Geräts</translation>
    </message>
    <message>
        <source>Value of the selected point, in %1</source>
        <translation>Wert des gewählten Punkts, in %1</translation>
    </message>
    <message>
        <source>Opacity of the selected point, 0 to 1, of a layer %1 mm thick</source>
        <translation>Deckkraft des gewählten Punkts, 0 bis 1, einer %1 mm dicken Lage</translation>
    </message>
    <message>
        <source>Colour of the point</source>
        <translation>Farbe des Punkts</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresentationDialog</name>
    <message>
        <source>Save Presentation State</source>
        <translation>Presentation State speichern</translation>
    </message>
    <message>
        <source>A DICOM object without pixels, for the archive: camera, colours, clip and shading of the 3D view. Macula draws the same picture of it; other programs draw what they can.</source>
        <translation>Ein DICOM-Objekt ohne Pixel, für das Archiv: Kamera, Farben, Beschnitt und Schattierung der 3D-Ansicht. Macula zeichnet daraus dasselbe Bild; andere Programme zeichnen, was sie können.</translation>
    </message>
    <message>
        <source>Nothing of the patient is written, and all UIDs are other ones. It can be opened where the series itself is.</source>
        <translation>Vom Patienten wird nichts geschrieben, und alle UIDs sind andere. Es kann geöffnet werden, wo die Serie selbst ist.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresentationsController</name>
    <message>
        <source>The presentation state is written to %1.</source>
        <translation>Der Presentation State ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Open Presen&amp;tation State…</source>
        <translation>Presen&amp;tation State öffnen…</translation>
    </message>
    <message>
        <source>Show this series as a DICOM presentation state says</source>
        <translation>Diese Serie zeigen, wie ein DICOM Presentation State es angibt</translation>
    </message>
    <message>
        <source>Save Presentation State…</source>
        <translation>Presentation State speichern…</translation>
    </message>
    <message>
        <source>The 3D view as a DICOM object, for the archive and other programs</source>
        <translation>Die 3D-Ansicht als DICOM-Objekt, für das Archiv und andere Programme</translation>
    </message>
    <message>
        <source>A presentation state is still being written.</source>
        <translation>Ein Presentation State wird noch geschrieben.</translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation>Keine Studie ist offen.</translation>
    </message>
    <message>
        <source>Open the series of the presentation state first.</source>
        <translation>Öffnen Sie zuerst die Serie des Presentation State.</translation>
    </message>
    <message>
        <source>Open a presentation state</source>
        <translation>Presentation State öffnen</translation>
    </message>
    <message>
        <source>DICOM files (*.dcm);;All files (*)</source>
        <translation>DICOM-Dateien (*.dcm);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose another one, or open the folder that its series is in.</source>
        <translation>Wählen Sie einen anderen, oder öffnen Sie den Ordner mit der Serie dazu.</translation>
    </message>
    <message>
        <source>Presentation state</source>
        <translation>Presentation State</translation>
    </message>
    <message>
        <source>A presentation state refers to DICOM images, and none are open.</source>
        <translation>Ein Presentation State bezieht sich auf DICOM-Bilder, und keine sind offen.</translation>
    </message>
    <message>
        <source>Open a folder with DICOM files, or save the view.</source>
        <translation>Öffnen Sie einen Ordner mit DICOM-Dateien, oder speichern Sie die Ansicht.</translation>
    </message>
    <message>
        <source>Save the presentation state</source>
        <translation>Presentation State speichern</translation>
    </message>
    <message>
        <source>DICOM files (*.dcm)</source>
        <translation>DICOM-Dateien (*.dcm)</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetBox</name>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetComparison</name>
    <message>
        <source>&amp;Beside each other</source>
        <translation>&amp;Nebeneinander</translation>
    </message>
    <message>
        <source>Compare presets</source>
        <translation>Voreinstellungen vergleichen</translation>
    </message>
    <message>
        <source>Where the two pictures meet</source>
        <translation>Wo die beiden Bilder sich treffen</translation>
    </message>
    <message>
        <source>Where the two pictures meet, from left to right</source>
        <translation>Wo die beiden Bilder sich treffen, von links nach rechts</translation>
    </message>
    <message>
        <source>Each picture as a whole, instead of one line between them</source>
        <translation>Jedes Bild als Ganzes, statt einer Linie dazwischen</translation>
    </message>
    <message>
        <source>&amp;Use %1</source>
        <translation>%1 &amp;verwenden</translation>
    </message>
    <message>
        <source>Show the volume with the preset at the right; can be undone</source>
        <translation>Das Volumen mit der rechten Voreinstellung zeigen; kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Drawing both</source>
        <translation>Beide werden gezeichnet</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetGallery</name>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Put the deleted preset back</source>
        <translation>Die gelöschte Voreinstellung zurückholen</translation>
    </message>
    <message>
        <source>The preset that was deleted last comes back as it was</source>
        <translation>Die zuletzt gelöschte Voreinstellung kommt zurück, wie sie war</translation>
    </message>
    <message>
        <source>Filter the presets</source>
        <translation>Voreinstellungen filtern</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Part of a name or a kind of image; Down or Enter goes to the presets, Esc ends it</source>
        <translation>Teil eines Namens oder eine Bildart; Ab oder Eingabe geht zu den Voreinstellungen, Esc beendet es</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keep or import a preset of your own</source>
        <translation>Eigene Voreinstellung behalten oder importieren</translation>
    </message>
    <message>
        <source>Keep the curve, or all that is seen, as a preset of your own; or import one</source>
        <translation>Die Kurve oder alles Gezeigte als eigene Voreinstellung behalten, oder eine importieren</translation>
    </message>
    <message>
        <source>Keep the &amp;Curve…</source>
        <translation>&amp;Kurve behalten…</translation>
    </message>
    <message>
        <source>The transfer function that is shown</source>
        <translation>Die gezeigte Übertragungsfunktion</translation>
    </message>
    <message>
        <source>Keep All That Is &amp;Seen…</source>
        <translation>Alles &amp;Gezeigte behalten…</translation>
    </message>
    <message>
        <source>Curve, look, lights, window, clip and camera, for other studies too</source>
        <translation>Kurve, Darstellung, Beleuchtung, Fensterung, Beschnitt und Kamera, auch für andere Studien</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Of Macula, 3D Slicer, ParaView, VolView, MITK, Horos or OsiriX</source>
        <translation>Von Macula, 3D Slicer, ParaView, VolView, MITK, Horos oder OsiriX</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Voreinstellungen</translation>
    </message>
    <message>
        <source>Each preset as it shows this volume, from anterior and coarse. A double click or Enter uses it.</source>
        <translation>Jede Voreinstellung, wie sie dieses Volumen zeigt, von anterior und grob. Ein Doppelklick oder Eingabe verwendet sie.</translation>
    </message>
    <message>
        <source>No preset matches “%1”.</source>
        <translation>Keine Voreinstellung passt zu „%1“.</translation>
    </message>
    <message>
        <source>“%1” is deleted.</source>
        <translation>„%1“ ist gelöscht.</translation>
    </message>
    <message>
        <source>There is nothing in this volume to draw small pictures of.</source>
        <translation>In diesem Volumen ist nichts, wovon kleine Bilder gezeichnet werden könnten.</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Verwenden</translation>
    </message>
    <message>
        <source>&amp;Compare with What Is Shown…</source>
        <translation>Mit dem Ge&amp;zeigten vergleichen…</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>&amp;Favorit</translation>
    </message>
    <message>
        <source>Save as C&amp;opy…</source>
        <translation>Als &amp;Kopie speichern…</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen…</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Built-in presets are never changed: save a copy</source>
        <translation>Eingebaute Voreinstellungen ändern sich nie: eine Kopie speichern</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>The curve, as a file for --preset and 3D Slicer</source>
        <translation>Die Kurve, als Datei für --preset und 3D Slicer</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetLibrary</name>
    <message>
        <source>Your presets could not be read: %1</source>
        <translation>Ihre Voreinstellungen konnten nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>Presets of yours that are damaged and were left out: %1.</source>
        <translation>Eigene Voreinstellungen, die beschädigt sind und weggelassen wurden: %1.</translation>
    </message>
    <message>
        <source>Presets of yours that this version of Macula cannot read, and leaves as they are: %1.</source>
        <translation>Eigene Voreinstellungen, die diese Version von Macula nicht lesen kann und lässt, wie sie sind: %1.</translation>
    </message>
    <message>
        <source>The last change of your presets is not stored and lasts until this window closes: %1</source>
        <translation>Die letzte Änderung Ihrer Voreinstellungen ist nicht gespeichert und gilt, bis dieses Fenster schließt: %1</translation>
    </message>
    <message>
        <source>Nothing is kept between runs: presets of your own live until this window closes. Export those that you need.</source>
        <translation>Zwischen Starts wird nichts aufbewahrt: eigene Voreinstellungen gelten, bis dieses Fenster schließt. Exportieren Sie die, die Sie brauchen.</translation>
    </message>
    <message>
        <source>Keep preset</source>
        <translation>Voreinstellung behalten</translation>
    </message>
    <message>
        <source>Rename preset</source>
        <translation>Voreinstellung umbenennen</translation>
    </message>
    <message>
        <source>Presets of the file that could not be kept: %1. %2</source>
        <translation>Voreinstellungen der Datei, die nicht behalten werden konnten: %1. %2</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetListModel</name>
    <message>
        <source>Favourites</source>
        <translation>Favoriten</translation>
    </message>
    <message>
        <source>Last used for such images</source>
        <translation>Zuletzt für solche Bilder verwendet</translation>
    </message>
    <message>
        <source>Your own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>For such images</source>
        <translation>Für solche Bilder</translation>
    </message>
    <message>
        <source>For other images</source>
        <translation>Für andere Bilder</translation>
    </message>
    <message>
        <source>all that was seen</source>
        <translation>alles Gezeigte</translation>
    </message>
    <message>
        <source>%1, all that was seen</source>
        <translation>%1, alles Gezeigte</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Enter or a click folds this group</source>
        <translation>Eingabe oder ein Klick klappt diese Gruppe zu</translation>
    </message>
    <message>
        <source>Enter or a click shows this group</source>
        <translation>Eingabe oder ein Klick zeigt diese Gruppe</translation>
    </message>
    <message>
        <source>your own</source>
        <translation>eigene</translation>
    </message>
    <message>
        <source>built in, is never changed</source>
        <translation>eingebaut, ändert sich nie</translation>
    </message>
    <message>
        <source>favourite</source>
        <translation>Favorit</translation>
    </message>
    <message>
        <source>shown now</source>
        <translation>jetzt gezeigt</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n presets, shown</source>
        <translation>
            <numerusform>%1, %n Voreinstellung, gezeigt</numerusform>
            <numerusform>%1, %n Voreinstellungen, gezeigt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n presets, folded</source>
        <translation>
            <numerusform>%1, %n Voreinstellung, zugeklappt</numerusform>
            <numerusform>%1, %n Voreinstellungen, zugeklappt</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetNameDialog</name>
    <message>
        <source>Name of the preset</source>
        <translation>Name der Voreinstellung</translation>
    </message>
    <message>
        <source>For all studies, so without anything of a patient</source>
        <translation>Für alle Studien, also ohne etwas von einem Patienten</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetNaming</name>
    <message>
        <source>Another name for “%1”.</source>
        <translation>Ein anderer Name für „%1“.</translation>
    </message>
    <message>
        <source>Rename the preset</source>
        <translation>Voreinstellung umbenennen</translation>
    </message>
    <message>
        <source>A preset of your own, like “%1”.</source>
        <translation>Eine eigene Voreinstellung, wie „%1“.</translation>
    </message>
    <message>
        <source>Save as copy</source>
        <translation>Als Kopie speichern</translation>
    </message>
    <message>
        <source>%1, as seen</source>
        <translation>%1, wie gezeigt</translation>
    </message>
    <message>
        <source>Curve, look, lights, window, clip and camera, as a preset of your own. It is for all studies: clip and camera go with the size of the volume.</source>
        <translation>Kurve, Darstellung, Beleuchtung, Fensterung, Beschnitt und Kamera, als eigene Voreinstellung. Sie gilt für alle Studien: Beschnitt und Kamera richten sich nach der Größe des Volumens.</translation>
    </message>
    <message>
        <source>Keep all that is seen</source>
        <translation>Alles Gezeigte behalten</translation>
    </message>
    <message>
        <source>The transfer function that is shown, as a preset of your own.</source>
        <translation>Die gezeigte Übertragungsfunktion, als eigene Voreinstellung.</translation>
    </message>
    <message>
        <source>Keep the curve</source>
        <translation>Kurve behalten</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PresetsController</name>
    <message>
        <source>Kept as presets of your own: %1.</source>
        <translation>Als eigene Voreinstellungen behalten: %1.</translation>
    </message>
    <message>
        <source>&amp;Preset</source>
        <translation>&amp;Voreinstellung</translation>
    </message>
    <message>
        <source>Save P&amp;reset…</source>
        <translation>&amp;Voreinstellung speichern…</translation>
    </message>
    <message>
        <source>The transfer function, for other studies and programs</source>
        <translation>Die Übertragungsfunktion, für andere Studien und Programme</translation>
    </message>
    <message>
        <source> Preset </source>
        <translation> Voreinstellung </translation>
    </message>
    <message>
        <source>In this look a preset that is chosen gives the window only</source>
        <translation>In dieser Darstellung gibt eine gewählte Voreinstellung nur die Fensterung vor</translation>
    </message>
    <message>
        <source>What is seen, and in which colours</source>
        <translation>Was zu sehen ist und in welchen Farben</translation>
    </message>
    <message>
        <source>For &amp;Other Images</source>
        <translation>Für &amp;andere Bilder</translation>
    </message>
    <message>
        <source>Keep the &amp;Curve…</source>
        <translation>&amp;Kurve behalten…</translation>
    </message>
    <message>
        <source>The transfer function that is shown, as a preset of your own</source>
        <translation>Die gezeigte Übertragungsfunktion, als eigene Voreinstellung</translation>
    </message>
    <message>
        <source>Keep All That Is &amp;Seen…</source>
        <translation>Alles &amp;Gezeigte behalten…</translation>
    </message>
    <message>
        <source>Curve, look, lights, window, clip and camera, as a preset of your own</source>
        <translation>Kurve, Darstellung, Beleuchtung, Fensterung, Beschnitt und Kamera, als eigene Voreinstellung</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Of Macula, 3D Slicer, ParaView, VolView, MITK, Horos or OsiriX</source>
        <translation>Von Macula, 3D Slicer, ParaView, VolView, MITK, Horos oder OsiriX</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>Import presets</source>
        <translation>Voreinstellungen importieren</translation>
    </message>
    <message>
        <source>Presets (*.json *.vp *.xml *.mrml *.plist);;All files (*)</source>
        <translation>Voreinstellungen (*.json *.vp *.xml *.mrml *.plist);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export the preset</source>
        <translation>Voreinstellung exportieren</translation>
    </message>
    <message>
        <source>Presets (*.json)</source>
        <translation>Voreinstellungen (*.json)</translation>
    </message>
    <message>
        <source>The preset is written to %1. Open it with --preset %1.</source>
        <translation>Die Voreinstellung ist in %1 gespeichert. Öffnen Sie sie mit --preset %1.</translation>
    </message>
    <message>
        <source>There is no preset to save yet.</source>
        <translation>Es gibt noch keine Voreinstellung zu speichern.</translation>
    </message>
    <message>
        <source>Save the preset</source>
        <translation>Voreinstellung speichern</translation>
    </message>
</context>
<context>
    <name>macula::viewer::PriorsController</name>
    <message>
        <source>The images name neither an ID nor a name and a date of birth, by which others of this patient could be found.</source>
        <translation>Die Bilder nennen weder eine ID noch Name und Geburtsdatum, mit denen andere dieses Patienten zu finden wären.</translation>
    </message>
    <message>
        <source>Searching…</source>
        <translation>Suche läuft…</translation>
    </message>
    <message numerus="yes">
        <source>%n other studies of this patient</source>
        <translation>
            <numerusform>%n andere Studie dieses Patienten</numerusform>
            <numerusform>%n andere Studien dieses Patienten</numerusform>
        </translation>
    </message>
    <message>
        <source>No other study of this patient was found.</source>
        <translation>Keine andere Studie dieses Patienten gefunden.</translation>
    </message>
    <message>
        <source>No other study of this patient is on this machine.</source>
        <translation>Keine andere Studie dieses Patienten liegt auf diesem Rechner.</translation>
    </message>
    <message numerus="yes">
        <source>%n other studies of this patient are listed in the panel Archive.</source>
        <translation>
            <numerusform>%n andere Studie dieses Patienten steht im Bereich Archiv.</numerusform>
            <numerusform>%n andere Studien dieses Patienten stehen im Bereich Archiv.</numerusform>
        </translation>
    </message>
    <message>
        <source>The archive has more of them.</source>
        <translation>Das Archiv hat noch mehr davon.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ProgramDialog</name>
    <message>
        <source>Segment by a Program</source>
        <translation>Mit einem Programm segmentieren</translation>
    </message>
    <message>
        <source>The program gets the open volume as a NIfTI file without patient data, {input}, and writes a map of segment numbers on the same voxels, {output}. It runs as you, and may do what you may: use only programs that you trust. Macula makes no statement about what it finds.</source>
        <translation>Das Programm bekommt das offene Volumen als NIfTI-Datei ohne Patientendaten, {input}, und schreibt auf denselben Voxeln eine Karte der Segmentnummern, {output}. Es läuft unter Ihrem Namen und darf, was Sie dürfen: Verwenden Sie nur Programme, denen Sie vertrauen. Macula sagt nichts darüber aus, was es findet.</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>A program, {input}, {output} and its options</source>
        <translation>Ein Programm, {input}, {output} und seine Optionen</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>The program is stopped after so many minutes</source>
        <translation>Nach so vielen Minuten wird das Programm beendet</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Ausführen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ProgramRun</name>
    <message numerus="yes">
        <source>The program took longer than %n minutes, and was stopped.</source>
        <translation>
            <numerusform>Das Programm brauchte länger als %n Minute und wurde beendet.</numerusform>
            <numerusform>Das Programm brauchte länger als %n Minuten und wurde beendet.</numerusform>
        </translation>
    </message>
    <message>
        <source>Allow more time, or let it work on a smaller volume.</source>
        <translation>Geben Sie ihm mehr Zeit oder ein kleineres Volumen.</translation>
    </message>
    <message>
        <source>The command has to name a program, {input} and {output}.</source>
        <translation>Der Befehl muss ein Programm, {input} und {output} nennen.</translation>
    </message>
    <message>
        <source>Write for example: my-model --in {input} --out {output}</source>
        <translation>Schreiben Sie zum Beispiel: my-model --in {input} --out {output}</translation>
    </message>
    <message>
        <source>No folder could be made for the program.</source>
        <translation>Für das Programm ließ sich kein Ordner anlegen.</translation>
    </message>
    <message>
        <source>Free some space for temporary files.</source>
        <translation>Schaffen Sie Platz für temporäre Dateien.</translation>
    </message>
    <message>
        <source>The program could not be started.</source>
        <translation>Das Programm ließ sich nicht starten.</translation>
    </message>
    <message>
        <source>Check its path, and that it may be run.</source>
        <translation>Prüfen Sie seinen Pfad und ob es ausgeführt werden darf.</translation>
    </message>
    <message>
        <source>The program is working</source>
        <translation>Das Programm arbeitet</translation>
    </message>
    <message>
        <source>The program ended with an error (code %1).</source>
        <translation>Das Programm endete mit einem Fehler (Code %1).</translation>
    </message>
    <message>
        <source>The program crashed.</source>
        <translation>Das Programm ist abgestürzt.</translation>
    </message>
    <message>
        <source>It said nothing about why.</source>
        <translation>Es hat nicht gesagt, warum.</translation>
    </message>
    <message>
        <source>It said: %1</source>
        <translation>Es meldete: %1</translation>
    </message>
    <message>
        <source>The program wrote no result.</source>
        <translation>Das Programm hat kein Ergebnis geschrieben.</translation>
    </message>
    <message>
        <source>It has to write the file that {output} names.</source>
        <translation>Es muss die Datei schreiben, die {output} nennt.</translation>
    </message>
    <message>
        <source>Reading the result</source>
        <translation>Das Ergebnis wird gelesen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::QualityControl</name>
    <message>
        <source>%L1 s</source>
        <translation>%L1 s</translation>
    </message>
    <message>
        <source>%L1 ms</source>
        <translation>%L1 ms</translation>
    </message>
    <message>
        <source>Quality of frames in motion</source>
        <translation>Qualität der Bilder in Bewegung</translation>
    </message>
    <message>
        <source>Quality of frames in motion, from fast to accurate</source>
        <translation>Qualität der Bilder in Bewegung, von schnell bis genau</translation>
    </message>
    <message>
        <source>How much of a frame is traced while a hand moves. At rest the picture always becomes final.</source>
        <translation>Wie viel eines Bildes während der Bewegung verfolgt wird. In Ruhe wird das Bild immer endgültig.</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatisch</translation>
    </message>
    <message>
        <source>As much as there is time for, without a choice</source>
        <translation>So viel, wie die Zeit erlaubt, ohne Auswahl</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Schnell</translation>
    </message>
    <message>
        <source>Accurate</source>
        <translation>Genau</translation>
    </message>
    <message>
        <source>Quality %1/%2</source>
        <translation>Qualität %1/%2</translation>
    </message>
    <message>
        <source>Quality of frames in motion. %1</source>
        <translation>Qualität der Bilder in Bewegung. %1</translation>
    </message>
    <message>
        <source>About %1 a frame on this machine.</source>
        <translation>Etwa %1 je Bild auf diesem Rechner.</translation>
    </message>
    <message>
        <source>How long a frame takes here is being measured.</source>
        <translation>Wie lange ein Bild hier braucht, wird gemessen.</translation>
    </message>
    <message>
        <source>Expected error (FLIP, 0 is none): %L1 where you look, %L2 in all.</source>
        <translation>Erwarteter Fehler (FLIP, 0 ist keiner): %L1, wo der Blick ist, %L2 im Ganzen.</translation>
    </message>
    <message>
        <source>It was measured with %1 bounces of light; the picture has %2 at every stop.</source>
        <translation>Gemessen wurde mit %1 Streuungen des Lichts; das Bild hat auf jeder Stufe %2.</translation>
    </message>
    <message>
        <source>Quality: automatic</source>
        <translation>Qualität: automatisch</translation>
    </message>
    <message>
        <source>Automatic: as much as there is time for. Move the slider to choose.</source>
        <translation>Automatisch: so viel, wie die Zeit erlaubt. Zum Wählen den Regler bewegen.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::QualityController</name>
    <message>
        <source>Converging</source>
        <translation>Wird fertig gezeichnet</translation>
    </message>
    <message>
        <source>Frames in Motion: Faster</source>
        <translation>Bilder in Bewegung: schneller</translation>
    </message>
    <message>
        <source>Less is traced while a hand moves</source>
        <translation>Während der Bewegung wird weniger verfolgt</translation>
    </message>
    <message>
        <source>Frames in Motion: More Accurate</source>
        <translation>Bilder in Bewegung: genauer</translation>
    </message>
    <message>
        <source>More is traced while a hand moves</source>
        <translation>Während der Bewegung wird mehr verfolgt</translation>
    </message>
    <message>
        <source>Converge &amp;Now</source>
        <translation>&amp;Jetzt fertig zeichnen</translation>
    </message>
    <message>
        <source>Trace the picture at rest until it is final, with half of the usual noise</source>
        <translation>Das ruhende Bild verfolgen, bis es endgültig ist, mit der Hälfte des üblichen Rauschens</translation>
    </message>
    <message>
        <source>Stop Converging</source>
        <translation>Fertigzeichnen anhalten</translation>
    </message>
    <message>
        <source>There is no picture to converge yet.</source>
        <translation>Es gibt noch kein Bild fertig zu zeichnen.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::QueueDialog</name>
    <message>
        <source>Waiting for Archives</source>
        <translation>Warteschlange für Archive</translation>
    </message>
    <message>
        <source>Objects that wait for archives</source>
        <translation>Objekte, die auf Archive warten</translation>
    </message>
    <message>
        <source>What was sent and is not stored there yet</source>
        <translation>Was gesendet wurde und dort noch nicht gespeichert ist</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>&amp;Send Now</source>
        <translation>&amp;Jetzt senden</translation>
    </message>
    <message>
        <source>&amp;Remove…</source>
        <translation>&amp;Entfernen…</translation>
    </message>
    <message>
        <source>Send the selected entries</source>
        <translation>Die gewählten Einträge senden</translation>
    </message>
    <message>
        <source>Remove them without sending them</source>
        <translation>Die gewählten Einträge entfernen, ohne sie zu senden</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>ausgeblendet</translation>
    </message>
    <message>
        <source>Nothing waits for an archive.</source>
        <translation>Nichts wartet auf ein Archiv.</translation>
    </message>
    <message>
        <source>Remove From the Queue</source>
        <translation>Aus der Warteschlange entfernen</translation>
    </message>
    <message numerus="yes">
        <source>Remove %n objects without sending them?</source>
        <translation>
            <numerusform>%n Objekt entfernen, ohne es zu senden?</numerusform>
            <numerusform>%n Objekte entfernen, ohne sie zu senden?</numerusform>
        </translation>
    </message>
    <message>
        <source>Pictures and views that were made to be sent are kept nowhere else.</source>
        <translation>Bilder und Ansichten, die zum Senden erstellt wurden, sind nirgends sonst aufbewahrt.</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ReceiveController</name>
    <message>
        <source>&amp;Receive Studies</source>
        <translation>Studien empfan&amp;gen</translation>
    </message>
    <message>
        <source>Take studies that others send to this machine, until it is switched off or the window closes; Settings, Receiving says who may send</source>
        <translation>Studien annehmen, die andere an diesen Rechner senden, bis das ausgeschaltet oder das Fenster geschlossen wird; wer senden darf, steht unter Einstellungen, „Empfang“</translation>
    </message>
    <message>
        <source>Macula now receives studies. What other machines send is not encrypted; a certificate in Settings, Receiving encrypts it.</source>
        <translation>Macula empfängt jetzt Studien. Was andere Rechner senden, ist nicht verschlüsselt; mit einem Zertifikat unter Einstellungen, „Empfang“ wird es verschlüsselt.</translation>
    </message>
    <message numerus="yes">
        <source>%n images are arriving at port %1</source>
        <translation>
            <numerusform>%n Bild kommt am Port %1 an</numerusform>
            <numerusform>%n Bilder kommen am Port %1 an</numerusform>
        </translation>
    </message>
    <message>
        <source>Receives as %1 at port %2</source>
        <translation>Empfängt als %1 am Port %2</translation>
    </message>
    <message>
        <source>Macula listens for studies that others send. File, Receive Studies ends it.</source>
        <translation>Macula lauscht auf Studien, die andere senden. Datei, „Studien empfangen“ beendet das.</translation>
    </message>
    <message numerus="yes">
        <source>%n connections were turned away. The last: %1</source>
        <translation>
            <numerusform>%n Verbindung wurde abgewiesen: %1</numerusform>
            <numerusform>%n Verbindungen wurden abgewiesen. Die letzte: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects were refused, and their sender was told so.</source>
        <translation>
            <numerusform>%n Objekt wurde abgelehnt, und das wurde dem Absender gemeldet.</numerusform>
            <numerusform>%n Objekte wurden abgelehnt, und das wurde dem Absender gemeldet.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::ReceivePage</name>
    <message>
        <source>&amp;Receive from the start of each window</source>
        <translation>Ab dem Start jedes Fensters e&amp;mpfangen</translation>
    </message>
    <message>
        <source>AE title of Macula</source>
        <translation>AE-Titel von Macula</translation>
    </message>
    <message>
        <source>The name that senders call; 1 to 16 letters, digits and signs</source>
        <translation>Der Name, den Absender ansprechen; 1 bis 16 Buchstaben, Ziffern und Zeichen</translation>
    </message>
    <message>
        <source>&amp;AE title</source>
        <translation>&amp;AE-Titel</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Where senders reach Macula, 1 to 65535; usually 11112</source>
        <translation>Wo Absender Macula erreichen, 1 bis 65535; meist 11112</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>Reached &amp;at</source>
        <translation>E&amp;rreichbar</translation>
    </message>
    <message>
        <source>&amp;Certificate</source>
        <translation>&amp;Zertifikat</translation>
    </message>
    <message>
        <source>PEM file of a certificate of this machine: connections are encrypted then</source>
        <translation>PEM-Datei eines Zertifikats dieses Rechners: Verbindungen sind dann verschlüsselt</translation>
    </message>
    <message>
        <source>Its &amp;key</source>
        <translation>Sein &amp;Schlüssel</translation>
    </message>
    <message>
        <source>PEM file of the key of the certificate</source>
        <translation>PEM-Datei des Schlüssels zum Zertifikat</translation>
    </message>
    <message>
        <source>A&amp;uthorities</source>
        <translation>Zerti&amp;fizierungsstellen</translation>
    </message>
    <message>
        <source>PEM file of who may sign the certificates that senders then must show</source>
        <translation>PEM-Datei der Stellen, von denen die Zertifikate signiert sein müssen, die Absender dann zeigen müssen</translation>
    </message>
    <message>
        <source>How much to take in all, in GB</source>
        <translation>Wie viel insgesamt angenommen wird, in GB</translation>
    </message>
    <message>
        <source>While one window is open, 0 to %1 GB; 0 is no limit</source>
        <translation>Solange ein Fenster offen ist, 0 bis %1 GB; 0 heißt keine Grenze</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source> GB</source>
        <translation> GB</translation>
    </message>
    <message>
        <source>&amp;Limit</source>
        <translation>&amp;Grenze</translation>
    </message>
    <message>
        <source>Receive from the start of each window</source>
        <translation>Ab dem Start jedes Fensters empfangen</translation>
    </message>
    <message>
        <source>Otherwise nothing listens until File, Receive Studies is chosen</source>
        <translation>Sonst lauscht nichts, bis Datei, „Studien empfangen“ gewählt wird</translation>
    </message>
    <message>
        <source>Who reaches Macula</source>
        <translation>Wer Macula erreicht</translation>
    </message>
    <message>
        <source>Programs of this machine alone, or other machines too</source>
        <translation>Nur Programme dieses Rechners oder auch andere Rechner</translation>
    </message>
    <message>
        <source>This machine alone</source>
        <translation>Nur von diesem Rechner aus</translation>
    </message>
    <message>
        <source>All addresses of this machine</source>
        <translation>Unter allen Adressen dieses Rechners</translation>
    </message>
    <message>
        <source>One address of this machine</source>
        <translation>Unter einer Adresse dieses Rechners</translation>
    </message>
    <message>
        <source>Address of this machine</source>
        <translation>Adresse dieses Rechners</translation>
    </message>
    <message>
        <source>An IP address of this machine, at which senders reach Macula</source>
        <translation>Eine IP-Adresse dieses Rechners, unter der Absender Macula erreichen</translation>
    </message>
    <message>
        <source>&amp;Who may send</source>
        <translation>&amp;Wer senden darf</translation>
    </message>
    <message>
        <source>TITLE, TITLE@ADDRESS or *@ADDRESS, several with commas between; an address may be a range, as *@10.1.0.0/16. AE titles alone prove nothing.</source>
        <translation>TITEL, TITEL@ADRESSE oder *@ADRESSE, mehrere durch Kommas getrennt; eine Adresse kann ein Bereich sein, wie *@10.1.0.0/16. AE-Titel allein beweisen nichts.</translation>
    </message>
    <message>
        <source>for example %1</source>
        <translation>zum Beispiel %1</translation>
    </message>
    <message>
        <source>&amp;Everybody who reaches this machine</source>
        <translation>A&amp;lle, die diesen Rechner erreichen</translation>
    </message>
    <message>
        <source>Everybody who reaches this machine may send</source>
        <translation>Alle, die diesen Rechner erreichen, dürfen senden</translation>
    </message>
    <message>
        <source>Whoever reaches the port may send, whatever stands above</source>
        <translation>Wer den Port erreicht, darf senden, was auch immer darüber steht</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>Choose the file of: %1</source>
        <translation>Datei wählen: %1</translation>
    </message>
    <message>
        <source>File, Receive Studies begins and ends it. Macula says what arrived, and opens nothing by itself.</source>
        <translation>Datei, „Studien empfangen“ beginnt und beendet den Empfang. Macula meldet, was angekommen ist, und öffnet nichts von selbst.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::RecentMenu</name>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>What was opened since the program was started; it is not kept for longer</source>
        <translation>Was seit dem Start des Programms geöffnet wurde; länger wird es nicht aufbewahrt</translation>
    </message>
    <message>
        <source>&amp;Forget All</source>
        <translation>Alle &amp;vergessen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SaveObjectDialog</name>
    <message>
        <source>&amp;Without patient and study</source>
        <translation>&amp;Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Without patient and study</source>
        <translation>Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>&amp;Choose File…</source>
        <translation>&amp;Datei wählen…</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SecondVolumeBar</name>
    <message>
        <source>Study alone</source>
        <translation>Studie allein</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Second alone</source>
        <translation>Zweites allein</translation>
    </message>
    <message>
        <source>In colours over the study</source>
        <translation>Farbig über der Studie</translation>
    </message>
    <message>
        <source>Hot iron</source>
        <translation>Glühendes Eisen</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Second Volume</source>
        <translation>Zweites Volumen</translation>
    </message>
    <message>
        <source>The second volume</source>
        <translation>Das zweite Volumen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close the second volume; the study stays</source>
        <translation>Das zweite Volumen schließen; die Studie bleibt</translation>
    </message>
    <message>
        <source>How the second volume is shown</source>
        <translation>Wie das zweite Volumen gezeigt wird</translation>
    </message>
    <message>
        <source>The second volume beside the study, in its place, or over it. J puts it in the place of the study, and back</source>
        <translation>Das zweite Volumen neben der Studie, an ihrer Stelle oder darüber. J setzt es an die Stelle der Studie und zurück</translation>
    </message>
    <message>
        <source>How the second volume is linked</source>
        <translation>Wie das zweite Volumen gekoppelt ist</translation>
    </message>
    <message>
        <source>What takes a place in the study to the same place in the second volume. By hand, the wheel over the second volume moves it alone</source>
        <translation>Was einen Ort der Studie an denselben Ort im zweiten Volumen führt. Von Hand bewegt das Rad über dem zweiten Volumen nur dieses</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Same frame of reference</source>
        <translation>Gleiches Koordinatensystem</translation>
    </message>
    <message>
        <source>Registered</source>
        <translation>Registriert</translation>
    </message>
    <message>
        <source>Colours of the second volume</source>
        <translation>Farben des zweiten Volumens</translation>
    </message>
    <message>
        <source>Colours of the second volume where it lies over the study</source>
        <translation>Farben des zweiten Volumens, wo es über der Studie liegt</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Opacity of the second volume in percent</source>
        <translation>Deckkraft des zweiten Volumens in Prozent</translation>
    </message>
    <message>
        <source>Opacity of the second volume over the study: %1 %</source>
        <translation>Deckkraft des zweiten Volumens über der Studie: %1 %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Window of the second volume from</source>
        <translation>Fensterung des zweiten Volumens von</translation>
    </message>
    <message>
        <source>Window of the second volume up to</source>
        <translation>Fensterung des zweiten Volumens bis</translation>
    </message>
    <message>
        <source>Window of the second volume</source>
        <translation>Fensterung des zweiten Volumens</translation>
    </message>
    <message>
        <source>What is black and what is white of the second volume, in its own unit</source>
        <translation>Was am zweiten Volumen schwarz und was weiß ist, in seiner eigenen Einheit</translation>
    </message>
    <message>
        <source>Registering…</source>
        <translation>Wird registriert…</translation>
    </message>
    <message>
        <source>In 3D too</source>
        <translation>Auch in 3D</translation>
    </message>
    <message>
        <source>The second volume in the 3D picture</source>
        <translation>Das zweite Volumen im 3D-Bild</translation>
    </message>
    <message>
        <source>The second volume in one 3D picture with the study. It has to be of the same patient, and linked by more than hand; projections show the study alone</source>
        <translation>Das zweite Volumen in einem 3D-Bild mit der Studie. Es muss vom selben Patienten und anders als von Hand verknüpft sein; Projektionen zeigen die Studie allein</translation>
    </message>
    <message>
        <source>Second volume in 3D</source>
        <translation>Zweites Volumen in 3D</translation>
    </message>
    <message>
        <source>Preset of the second volume in 3D</source>
        <translation>Voreinstellung des zweiten Volumens in 3D</translation>
    </message>
    <message>
        <source>What the second volume is drawn with in 3D: window, colours and opacity from here, or a preset</source>
        <translation>Womit das zweite Volumen in 3D gezeichnet wird: Fensterung, Farben und Deckkraft von hier, oder eine Voreinstellung</translation>
    </message>
    <message>
        <source>Preset of the second volume</source>
        <translation>Voreinstellung des zweiten Volumens</translation>
    </message>
    <message>
        <source>As over slices</source>
        <translation>Wie über Schichten</translation>
    </message>
    <message>
        <source>One window</source>
        <translation>Ein Fenster</translation>
    </message>
    <message>
        <source>One window for the study and the second volume</source>
        <translation>Ein Fenster für die Untersuchung und das zweite Volumen</translation>
    </message>
    <message>
        <source>Slices of both through one window, as phases are compared. Both have to have one unit</source>
        <translation>Schichten von beiden durch ein Fenster, wie Phasen verglichen werden. Beide müssen eine Einheit haben</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SecondVolumeController</name>
    <message>
        <source>The second volume that was beside this study is not open; open it with Ctrl+B to see both as they were.</source>
        <translation>Das zweite Volumen, das neben dieser Studie stand, ist nicht geöffnet; Strg+B öffnet es und zeigt beide, wie sie waren.</translation>
    </message>
    <message>
        <source>Where the second volume lay when this study was left is not taken over: the images had other values or positions then, or an older Macula kept it. It is placed anew.</source>
        <translation>Wo das zweite Volumen lag, als diese Studie verlassen wurde, wird nicht übernommen: Die Bilder hatten damals andere Werte oder Positionen, oder ein älteres Macula hat es aufgehoben. Es wird neu eingepasst.</translation>
    </message>
    <message>
        <source>Second volume: %1</source>
        <translation>Zweites Volumen: %1</translation>
    </message>
    <message>
        <source>The second volume shows another part of the body: nothing of it lies in the study.</source>
        <translation>Das zweite Volumen zeigt einen anderen Teil des Körpers: nichts davon liegt in der Studie.</translation>
    </message>
    <message>
        <source>Open &amp;Beside…</source>
        <translation>Da&amp;neben öffnen…</translation>
    </message>
    <message>
        <source>A prior, a PET or an MR beside this study: what is selected in the list of studies, else of a folder</source>
        <translation>Eine Voraufnahme, ein PET oder ein MR neben dieser Studie: was in der Liste der Studien gewählt ist, sonst aus einem Ordner</translation>
    </message>
    <message>
        <source>Open File Besi&amp;de…</source>
        <translation>Datei daneben ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>The series of an image, or a NIfTI, NRRD or MetaImage file, beside this study</source>
        <translation>Die Serie eines Bildes oder eine NIfTI-, NRRD- oder MetaImage-Datei neben dieser Studie</translation>
    </message>
    <message>
        <source>&amp;Close Second Volume</source>
        <translation>Zweites Volumen s&amp;chließen</translation>
    </message>
    <message>
        <source>The study stays open</source>
        <translation>Die Studie bleibt offen</translation>
    </message>
    <message>
        <source>Second Volume in the Place of the Study</source>
        <translation>Zweites Volumen an Stelle der Studie</translation>
    </message>
    <message>
        <source>The same planes of the second volume, and back</source>
        <translation>Dieselben Ebenen des zweiten Volumens, und zurück</translation>
    </message>
    <message>
        <source>Open a second volume beside the study</source>
        <translation>Zweites Volumen neben der Studie öffnen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SecondVolumeLoader</name>
    <message>
        <source>Registering the second volume</source>
        <translation>Das zweite Volumen wird registriert</translation>
    </message>
    <message>
        <source>Opening the second volume</source>
        <translation>Das zweite Volumen wird geöffnet</translation>
    </message>
    <message>
        <source>There is no study that a second volume could be beside.</source>
        <translation>Es gibt keine Studie, neben der ein zweites Volumen stehen könnte.</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>Second volume closed</source>
        <translation>Zweites Volumen geschlossen</translation>
    </message>
    <message>
        <source>This is the volume that is open already.</source>
        <translation>Das ist das Volumen, das schon offen ist.</translation>
    </message>
    <message>
        <source>Choose another series to stand beside it.</source>
        <translation>Wählen Sie eine andere Serie, die daneben steht.</translation>
    </message>
    <message>
        <source>Second volume</source>
        <translation>Zweites Volumen</translation>
    </message>
    <message>
        <source>Registration</source>
        <translation>Registrierung</translation>
    </message>
    <message>
        <source>Same frame of reference</source>
        <translation>Gleiches Koordinatensystem</translation>
    </message>
    <message>
        <source>Linked by hand</source>
        <translation>Von Hand gekoppelt</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentWork</name>
    <message>
        <source>New segment</source>
        <translation>Neues Segment</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>Name of the segment</source>
        <translation>Name des Segments</translation>
    </message>
    <message>
        <source>Delete segment</source>
        <translation>Segment löschen</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwellen</translation>
    </message>
    <message>
        <source>Growing stopped at %1 ml: it may have leaked.</source>
        <translation>Das Wachsen endete bei %1 ml: Es ist vielleicht ausgelaufen.</translation>
    </message>
    <message>
        <source>Growing</source>
        <translation>Wachsen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Nothing was found.</source>
        <translation>Nichts gefunden.</translation>
    </message>
    <message>
        <source>Preview: %1 ml, in no segment yet.</source>
        <translation>Vorschau: %1 ml, noch in keinem Segment.</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>Add to the segment</source>
        <translation>Zum Segment hinzufügen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentationKeeper</name>
    <message>
        <source>Segmentations</source>
        <translation>Segmentierungen</translation>
    </message>
    <message>
        <source>A segmentation that was shown with this study is not in the folder; nothing of it is shown or hidden.</source>
        <translation>Eine Segmentierung, die mit dieser Studie gezeigt wurde, ist nicht im Ordner; nichts davon wird gezeigt oder ausgeblendet.</translation>
    </message>
    <message numerus="yes">
        <source>There are %n segmentations of this volume: F11.</source>
        <translation>
            <numerusform>Es gibt eine Segmentierung dieses Volumens: F11.</numerusform>
            <numerusform>Es gibt %n Segmentierungen dieses Volumens: F11.</numerusform>
        </translation>
    </message>
    <message>
        <source>Own segments</source>
        <translation>Eigene Segmente</translation>
    </message>
    <message>
        <source>Open segmentation</source>
        <translation>Segmentierung öffnen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentationPanel</name>
    <message>
        <source>Drawn by hand</source>
        <translation>Von Hand gezeichnet</translation>
    </message>
    <message>
        <source>Made by a person with a program</source>
        <translation>Von einem Menschen mit einem Programm erstellt</translation>
    </message>
    <message>
        <source>Made by a program</source>
        <translation>Von einem Programm erstellt</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>Segment %1</translation>
    </message>
    <message>
        <source>alone</source>
        <translation>allein</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>ausgeblendet</translation>
    </message>
    <message>
        <source>Segmentations</source>
        <translation>Segmentierungen</translation>
    </message>
    <message>
        <source>Segmentations of the folder; a check mark shows them on slices</source>
        <translation>Segmentierungen des Ordners; ein Häkchen zeigt sie auf Schichten</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>Segment</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Colour of the segment on slices, and in 3D where it is in colour there</source>
        <translation>Farbe des Segments auf Schichten, und in 3D, wo es dort farbig ist</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Cross-hair to the middle of the segment</source>
        <translation>Fadenkreuz in die Mitte des Segments</translation>
    </message>
    <message>
        <source>Alone</source>
        <translation>Allein</translation>
    </message>
    <message>
        <source>In 3D, this segment and others that are alone, and nothing else</source>
        <translation>In 3D dieses Segment und andere, die allein sind, und sonst nichts</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>In 3D, all but this segment</source>
        <translation>In 3D alles außer diesem Segment</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>How opaque the segment is filled on slices, in %</source>
        <translation>Wie deckend das Segment auf Schichten gefüllt ist, in %</translation>
    </message>
    <message>
        <source>In 3D</source>
        <translation>In 3D</translation>
    </message>
    <message>
        <source>Segmentation %1</source>
        <translation>Segmentierung %1</translation>
    </message>
    <message>
        <source>Volume in ml, once the segmentation is shown</source>
        <translation>Volumen in ml, sobald die Segmentierung gezeigt wird</translation>
    </message>
    <message>
        <source>Volume in ml: its voxels, times that of one</source>
        <translation>Volumen in ml: seine Voxel mal das eines Voxels</translation>
    </message>
    <message>
        <source>Open a study first.</source>
        <translation>Öffnen Sie zuerst eine Studie.</translation>
    </message>
    <message>
        <source>Looking for segmentations.</source>
        <translation>Segmentierungen werden gesucht.</translation>
    </message>
    <message>
        <source>There are no segmentations in this folder.</source>
        <translation>In diesem Ordner sind keine Segmentierungen.</translation>
    </message>
    <message>
        <source>This segment has no voxel in the volume.</source>
        <translation>Dieses Segment hat im Volumen kein Voxel.</translation>
    </message>
    <message>
        <source>Colour of the segment</source>
        <translation>Farbe des Segments</translation>
    </message>
    <message>
        <source>in colour</source>
        <translation>farbig</translation>
    </message>
    <message>
        <source>In colour</source>
        <translation>Farbig</translation>
    </message>
    <message>
        <source>In 3D, the matter in this segment has the colour of the segment</source>
        <translation>In 3D hat das Gewebe in diesem Segment die Farbe des Segments</translation>
    </message>
    <message>
        <source>In 3D, how much of the matter in a segment in colour is left, in %</source>
        <translation>In 3D, wie viel vom Gewebe eines farbigen Segments bleibt, in %</translation>
    </message>
    <message>
        <source>Opacity in 3D</source>
        <translation>Deckkraft in 3D</translation>
    </message>
    <message>
        <source>Volumes are estimates: the size of a pixel is not calibrated.</source>
        <translation>Volumina sind Schätzungen: Die Pixelgröße ist nicht kalibriert.</translation>
    </message>
    <message>
        <source>Made here, by you: they are in no file of the folder</source>
        <translation>Hier von Ihnen gemacht: Sie sind in keiner Datei des Ordners</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentationsController</name>
    <message>
        <source>Loading a segmentation</source>
        <translation>Eine Segmentierung wird geladen</translation>
    </message>
    <message>
        <source>The segmentation is written to %1.</source>
        <translation>Die Segmentierung ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Save Se&amp;gmentation as DICOM…</source>
        <translation>Segmentier&amp;ung als DICOM-Objekt speichern…</translation>
    </message>
    <message>
        <source>The segments that are shown, as an object for the archive and other programs</source>
        <translation>Die gezeigten Segmente als Objekt für das Archiv und andere Programme</translation>
    </message>
    <message>
        <source>No segmentation is shown.</source>
        <translation>Es wird keine Segmentierung gezeigt.</translation>
    </message>
    <message>
        <source>Show one in the panel Segmentations, F11, and wait until it is loaded.</source>
        <translation>Zeigen Sie eine im Bereich Segmentierungen, F11, und warten Sie, bis sie geladen ist.</translation>
    </message>
    <message>
        <source>A segmentation is still being written.</source>
        <translation>Eine Segmentierung wird noch geschrieben.</translation>
    </message>
    <message>
        <source>Save Segmentation as DICOM</source>
        <translation>Segmentierung als DICOM-Objekt speichern</translation>
    </message>
    <message numerus="yes">
        <source>A segmentation object for the archive: the %n segments of what is shown, on the voxels of this series, with labels, colours and codes.</source>
        <translation>
            <numerusform>Ein Segmentierungsobjekt für das Archiv: das gezeigte Segment, auf den Voxeln dieser Serie, mit Label, Farbe und Code.</numerusform>
            <numerusform>Ein Segmentierungsobjekt für das Archiv: die %n gezeigten Segmente, auf den Voxeln dieser Serie, mit Labels, Farben und Codes.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing of the patient is written, no label, and all UIDs are other ones.</source>
        <translation>Vom Patienten wird nichts geschrieben, auch keine Beschriftung, und alle UIDs sind andere.</translation>
    </message>
    <message>
        <source>Save the segmentation</source>
        <translation>Segmentierung speichern</translation>
    </message>
    <message>
        <source>DICOM files (*.dcm)</source>
        <translation>DICOM-Dateien (*.dcm)</translation>
    </message>
    <message>
        <source>Opening a segmentation</source>
        <translation>Eine Segmentierung wird geöffnet</translation>
    </message>
    <message>
        <source>Open Segme&amp;ntation…</source>
        <translation>Segme&amp;ntierung öffnen …</translation>
    </message>
    <message>
        <source>A label map of another program, on the voxels of the open volume: NIfTI, NRRD, MetaImage. DICOM segmentations are found by themselves in the folder</source>
        <translation>Eine Label-Map eines anderen Programms, auf den Voxeln des geöffneten Volumens: NIfTI, NRRD, MetaImage. DICOM-Segmentierungen im Ordner findet Macula von selbst</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentingController</name>
    <message>
        <source>The segments are written to %1.</source>
        <translation>Die Segmente sind in %1 geschrieben.</translation>
    </message>
    <message>
        <source>Segments of a program</source>
        <translation>Segmente eines Programms</translation>
    </message>
    <message numerus="yes">
        <source>The program made %n segments. Nobody has checked them yet.</source>
        <translation>
            <numerusform>Das Programm hat %n Segment gemacht. Noch hat es niemand geprüft.</numerusform>
            <numerusform>Das Programm hat %n Segmente gemacht. Noch hat sie niemand geprüft.</numerusform>
        </translation>
    </message>
    <message>
        <source>Save Own Segments…</source>
        <translation>Eigene Segmente speichern …</translation>
    </message>
    <message>
        <source>A NIfTI label map, or the surface of a segment as STL or glTF</source>
        <translation>Eine NIfTI-Karte der Segmente oder die Oberfläche eines Segments als STL oder glTF</translation>
    </message>
    <message>
        <source>Segment by a Program…</source>
        <translation>Mit einem Programm segmentieren …</translation>
    </message>
    <message>
        <source>Lets a program of your own segment the open volume</source>
        <translation>Lässt ein eigenes Programm das offene Volumen segmentieren</translation>
    </message>
    <message>
        <source>Segments are still being written.</source>
        <translation>Segmente werden noch geschrieben.</translation>
    </message>
    <message>
        <source>A program is still segmenting.</source>
        <translation>Ein Programm segmentiert noch.</translation>
    </message>
    <message>
        <source>Own segments are in no file, and are not kept.</source>
        <translation>Eigene Segmente sind in keiner Datei und werden nicht aufbewahrt.</translation>
    </message>
    <message>
        <source>There are no own segments.</source>
        <translation>Es gibt keine eigenen Segmente.</translation>
    </message>
    <message>
        <source>Make one in the panel Segmentations, F11.</source>
        <translation>Legen Sie eines im Bedienfeld Segmentierungen an, F11.</translation>
    </message>
    <message>
        <source>Save own segments</source>
        <translation>Eigene Segmente speichern</translation>
    </message>
    <message>
        <source>NIfTI label map of all (*.nii.gz);;Surface of the selected one, STL (*.stl);;Surface of the selected one, glTF (*.glb)</source>
        <translation>NIfTI-Karte aller Segmente (*.nii.gz);;Oberfläche des gewählten, STL (*.stl);;Oberfläche des gewählten, glTF (*.glb)</translation>
    </message>
    <message>
        <source>Saving segments</source>
        <translation>Segmente werden gespeichert</translation>
    </message>
    <message>
        <source>No study is open.</source>
        <translation>Es ist keine Studie geöffnet.</translation>
    </message>
    <message>
        <source>Segmenting by a program</source>
        <translation>Ein Programm segmentiert</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SegmentingPanel</name>
    <message>
        <source>New segment…</source>
        <translation>Neues Segment …</translation>
    </message>
    <message>
        <source>A segment of your own, on the voxels of this volume; it is kept with the study</source>
        <translation>Ein eigenes Segment auf den Voxeln dieses Volumens; es wird mit der Studie aufbewahrt</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen …</translation>
    </message>
    <message>
        <source>Another name for the own segment</source>
        <translation>Ein anderer Name für das eigene Segment</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Deletes the own segment; Undo brings it back</source>
        <translation>Löscht das eigene Segment; Rückgängig bringt es zurück</translation>
    </message>
    <message>
        <source>New segment</source>
        <translation>Neues Segment</translation>
    </message>
    <message>
        <source>Name of the segment</source>
        <translation>Name des Segments</translation>
    </message>
    <message>
        <source>Name, without anything of the patient:</source>
        <translation>Name, ohne Angaben zum Patienten:</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>What the tool Segment does on slices</source>
        <translation>Was das Werkzeug Segment auf Schichten tut</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Grow from a click</source>
        <translation>Von einem Klick wachsen</translation>
    </message>
    <message>
        <source>On slices</source>
        <translation>Auf Schichten</translation>
    </message>
    <message>
        <source>Takes the tool Segment</source>
        <translation>Nimmt das Werkzeug Segment</translation>
    </message>
    <message>
        <source>Radius of the brush, in mm</source>
        <translation>Radius des Pinsels in mm</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>One slice</source>
        <translation>Eine Schicht</translation>
    </message>
    <message>
        <source>The brush is a disc in the slice that is shown, and no ball</source>
        <translation>Der Pinsel ist eine Scheibe in der gezeigten Schicht und keine Kugel</translation>
    </message>
    <message>
        <source>Growing takes values so far from the mean around the click, in their unit</source>
        <translation>Das Wachsen nimmt Werte, die so weit vom Mittel um den Klick liegen, in ihrer Einheit</translation>
    </message>
    <message>
        <source>Growing stops at this volume</source>
        <translation>Bei diesem Volumen endet das Wachsen</translation>
    </message>
    <message>
        <source>Over corners</source>
        <translation>Über Ecken</translation>
    </message>
    <message>
        <source>Growing goes on over edges and corners of voxels, too (26 neighbours instead of 6)</source>
        <translation>Das Wachsen geht auch über Kanten und Ecken der Voxel (26 Nachbarn statt 6)</translation>
    </message>
    <message>
        <source>Within the segment</source>
        <translation>Nur im Segment</translation>
    </message>
    <message>
        <source>Growing and threshold look in the selected segment alone</source>
        <translation>Wachsen und Schwellen suchen nur im gewählten Segment</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Tolerance ±</source>
        <translation>Toleranz ±</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>Lowest value of the threshold</source>
        <translation>Untere Schwelle</translation>
    </message>
    <message>
        <source>Highest value of the threshold</source>
        <translation>Obere Schwelle</translation>
    </message>
    <message>
        <source>From the window</source>
        <translation>Aus dem Fenster</translation>
    </message>
    <message>
        <source>The threshold goes from the lower to the upper end of the display window</source>
        <translation>Die Schwellen sind das untere und das obere Ende des Anzeigefensters</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwellen</translation>
    </message>
    <message>
        <source>Shows on slices which voxels have such values</source>
        <translation>Zeigt auf Schichten, welche Voxel solche Werte haben</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Adds the preview to the segment</source>
        <translation>Fügt die Vorschau zum Segment hinzu</translation>
    </message>
    <message>
        <source>Take away</source>
        <translation>Wegnehmen</translation>
    </message>
    <message>
        <source>Takes the preview away from the segment</source>
        <translation>Nimmt die Vorschau vom Segment weg</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>The segment becomes the preview</source>
        <translation>Das Segment wird zur Vorschau</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Forgets the preview</source>
        <translation>Verwirft die Vorschau</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>What is done to the whole segment</source>
        <translation>Was mit dem ganzen Segment geschieht</translation>
    </message>
    <message>
        <source>Keep the largest part</source>
        <translation>Größten Teil behalten</translation>
    </message>
    <message>
        <source>Remove parts below</source>
        <translation>Teile entfernen unter</translation>
    </message>
    <message>
        <source>Smooth: median of</source>
        <translation>Glätten: Median von</translation>
    </message>
    <message>
        <source>Smooth: Gaussian of</source>
        <translation>Glätten: Gauß von</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Fill between slices</source>
        <translation>Zwischen Schichten füllen</translation>
    </message>
    <message>
        <source>Grow by</source>
        <translation>Vergrößern um</translation>
    </message>
    <message>
        <source>Shrink by</source>
        <translation>Verkleinern um</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Wie viel</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Changes the segment; Undo takes it back</source>
        <translation>Ändert das Segment; Rückgängig nimmt es zurück</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>NIfTI, STL or glTF; DICOM is in the File menu</source>
        <translation>NIfTI, STL oder glTF; DICOM ist im Menü Datei</translation>
    </message>
    <message>
        <source>By a program…</source>
        <translation>Mit einem Programm …</translation>
    </message>
    <message>
        <source>Lets a program of your own segment this volume</source>
        <translation>Lässt ein eigenes Programm dieses Volumen segmentieren</translation>
    </message>
    <message>
        <source>No own segment is selected: painting and previews make a new one.</source>
        <translation>Kein eigenes Segment ist gewählt: Malen und Vorschauen legen ein neues an.</translation>
    </message>
    <message>
        <source>%1: being counted.</source>
        <translation>%1: wird gezählt.</translation>
    </message>
    <message>
        <source>%1: %2 ml.</source>
        <translation>%1: %2 ml.</translation>
    </message>
    <message>
        <source>Mean %1, SD %2, from %3 to %4 %5.</source>
        <translation>Mittel %1, SD %2, von %3 bis %4 %5.</translation>
    </message>
    <message numerus="yes">
        <source>%n voxels have no value, and are left out of these.</source>
        <translation>
            <numerusform>%n Voxel hat keinen Wert und ist darin nicht enthalten.</numerusform>
            <numerusform>%n Voxel haben keinen Wert und sind darin nicht enthalten.</numerusform>
        </translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SendController</name>
    <message>
        <source>&amp;Waiting for Archives…</source>
        <translation>&amp;Warteschlange für Archive…</translation>
    </message>
    <message>
        <source>What was sent and is not stored there yet</source>
        <translation>Was gesendet wurde und dort noch nicht gespeichert ist</translation>
    </message>
    <message>
        <source>Objects are still being sent to an archive.</source>
        <translation>Es werden noch Objekte an ein Archiv gesendet.</translation>
    </message>
    <message>
        <source>No archive has been set up yet.</source>
        <translation>Es ist noch kein Archiv eingerichtet.</translation>
    </message>
    <message>
        <source>Set one up in the panel Archive, or ask your administrator.</source>
        <translation>Richten Sie im Bereich Archiv eines ein, oder fragen Sie Ihre Systemverwaltung.</translation>
    </message>
    <message>
        <source>No DICOM study is open, so there is no patient to whom a picture could belong.</source>
        <translation>Keine DICOM-Studie ist offen, also gibt es keinen Patienten, zu dem ein Bild gehören könnte.</translation>
    </message>
    <message>
        <source>Send a folder</source>
        <translation>Einen Ordner senden</translation>
    </message>
    <message>
        <source>Send DICOM files</source>
        <translation>DICOM-Dateien senden</translation>
    </message>
    <message>
        <source>Sending to %1</source>
        <translation>An %1 wird gesendet</translation>
    </message>
    <message>
        <source>Sending to an archive</source>
        <translation>An ein Archiv wird gesendet</translation>
    </message>
    <message>
        <source>Sending was cancelled. What was not stored yet is not sent.</source>
        <translation>Das Senden wurde abgebrochen. Was noch nicht gespeichert war, wird nicht gesendet.</translation>
    </message>
    <message numerus="yes">
        <source>%n objects are stored.</source>
        <translation>
            <numerusform>%n Objekt ist gespeichert.</numerusform>
            <numerusform>%n Objekte sind gespeichert.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects are stored in %1.</source>
        <translation>
            <numerusform>%n Objekt ist in %1 gespeichert.</numerusform>
            <numerusform>%n Objekte sind in %1 gespeichert.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The archive refused %n objects; File, Waiting for Archives says why.</source>
        <translation>
            <numerusform>Das Archiv hat %n Objekt abgelehnt; unter Datei, „Warteschlange für Archive“ steht, warum.</numerusform>
            <numerusform>Das Archiv hat %n Objekte abgelehnt; unter Datei, „Warteschlange für Archive“ steht, warum.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects wait in the queue.</source>
        <translation>
            <numerusform>%n Objekt wartet in der Warteschlange.</numerusform>
            <numerusform>%n Objekte warten in der Warteschlange.</numerusform>
        </translation>
    </message>
    <message>
        <source>Se&amp;nd to an Archive…</source>
        <translation>An ein Arc&amp;hiv senden…</translation>
    </message>
    <message>
        <source>Store the picture, the view, measurements, segments or DICOM files in a PACS</source>
        <translation>Das Bild, die Ansicht, Messungen, Segmente oder DICOM-Dateien in einem PACS speichern</translation>
    </message>
    <message>
        <source>%1 is at %2 now. When objects were sent to it, it was at %3.</source>
        <translation>Das Archiv %1 hat jetzt die Adresse %2. Als Objekte an das Archiv gesendet wurden, hatte es die Adresse %3.</translation>
    </message>
    <message>
        <source>Send to Another Address</source>
        <translation>An eine andere Adresse senden</translation>
    </message>
    <message>
        <source>Send only if it is the same archive.</source>
        <translation>Senden Sie nur, wenn es dasselbe Archiv ist.</translation>
    </message>
    <message>
        <source>&amp;Send There</source>
        <translation>&amp;Dorthin senden</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SendDialog</name>
    <message>
        <source>&amp;Picture of the 3D view (Secondary Capture)</source>
        <translation>&amp;Bild der 3D-Ansicht (Secondary Capture)</translation>
    </message>
    <message>
        <source>&amp;View in 3D (presentation state, no pixels)</source>
        <translation>A&amp;nsicht in 3D (Presentation State, ohne Pixel)</translation>
    </message>
    <message>
        <source>&amp;Without patient and study</source>
        <translation>&amp;Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Send to an Archive</source>
        <translation>An ein Archiv senden</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>The archive (PACS) in which they are stored</source>
        <translation>Das Archiv (PACS), in dem sie gespeichert werden</translation>
    </message>
    <message>
        <source>&amp;Archive</source>
        <translation>&amp;Archiv</translation>
    </message>
    <message>
        <source>Patients</source>
        <translation>Patienten</translation>
    </message>
    <message>
        <source>Picture of the 3D view</source>
        <translation>Bild der 3D-Ansicht</translation>
    </message>
    <message>
        <source>Drawn with cube, scale and letters, at the quality of the settings</source>
        <translation>Mit Würfel, Maßstab und Buchstaben gezeichnet, in der Qualität der Einstellungen</translation>
    </message>
    <message>
        <source>Size of the picture</source>
        <translation>Größe des Bildes</translation>
    </message>
    <message>
        <source>In pixels</source>
        <translation>In Pixeln</translation>
    </message>
    <message>
        <source>View in 3D</source>
        <translation>Ansicht in 3D</translation>
    </message>
    <message>
        <source>Camera, colours, clip and shading; Macula draws the same picture of it</source>
        <translation>Kamera, Farben, Beschnitt und Schattierung; Macula zeichnet daraus dasselbe Bild</translation>
    </message>
    <message>
        <source>Without patient and study</source>
        <translation>Ohne Patient und Studie</translation>
    </message>
    <message>
        <source>As on screen</source>
        <translation>Wie auf dem Bildschirm</translation>
    </message>
    <message>
        <source>As the panes</source>
        <translation>Wie die Bildfelder</translation>
    </message>
    <message>
        <source>Twice as large</source>
        <translation>Doppelt so groß</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>Full HD</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Quadrat</translation>
    </message>
    <message>
        <source>Large square</source>
        <translation>Großes Quadrat</translation>
    </message>
    <message>
        <source>Add &amp;Files…</source>
        <translation>&amp;Dateien hinzufügen…</translation>
    </message>
    <message>
        <source>DICOM files from a disk, as they are</source>
        <translation>DICOM-Dateien von einem Datenträger, wie sie sind</translation>
    </message>
    <message>
        <source>Add F&amp;older…</source>
        <translation>O&amp;rdner hinzufügen…</translation>
    </message>
    <message>
        <source>All DICOM files in a folder and below it</source>
        <translation>Alle DICOM-Dateien in einem Ordner und darunter</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Keine</translation>
    </message>
    <message>
        <source>Send no files from a disk</source>
        <translation>Keine Dateien von einem Datenträger senden</translation>
    </message>
    <message>
        <source>No files from a disk</source>
        <translation>Keine Dateien von einem Datenträger</translation>
    </message>
    <message>
        <source>&amp;Send</source>
        <translation>&amp;Senden</translation>
    </message>
    <message>
        <source>Store these objects in the archive, in the background</source>
        <translation>Diese Objekte im Hintergrund im Archiv speichern</translation>
    </message>
    <message>
        <source>Send nothing</source>
        <translation>Nichts senden</translation>
    </message>
    <message>
        <source>Reading files…</source>
        <translation>Dateien werden gelesen…</translation>
    </message>
    <message numerus="yes">
        <source>%n files</source>
        <translation>
            <numerusform>%n Datei</numerusform>
            <numerusform>%n Dateien</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose what to send.</source>
        <translation>Wählen Sie, was gesendet werden soll.</translation>
    </message>
    <message numerus="yes">
        <source>Send %n objects to %1, of:</source>
        <translation>
            <numerusform>%n Objekt an %1 senden, von:</numerusform>
            <numerusform>%n Objekte an %1 senden, von:</numerusform>
        </translation>
    </message>
    <message>
        <source>A pseudonym, in place of patient and study</source>
        <translation>Ein Pseudonym anstelle von Patient und Studie</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und noch %n</numerusform>
            <numerusform>und noch %n</numerusform>
        </translation>
    </message>
    <message>
        <source>These objects are not of one patient.</source>
        <translation>Diese Objekte sind nicht alle vom selben Patienten.</translation>
    </message>
    <message>
        <source>No date of birth</source>
        <translation>Kein Geburtsdatum</translation>
    </message>
    <message>
        <source>&amp;Measurements (%1, structured report)</source>
        <translation>&amp;Messungen (%1, Structured Report)</translation>
    </message>
    <message>
        <source>&amp;Measurements (none)</source>
        <translation>&amp;Messungen (keine)</translation>
    </message>
    <message>
        <source>Measurements</source>
        <translation>Messungen</translation>
    </message>
    <message>
        <source>Lengths, angles, areas and values with their places in the images, unverified</source>
        <translation>Längen, Winkel, Flächen und Werte mit ihrer Lage in den Bildern, nicht verifiziert</translation>
    </message>
    <message numerus="yes">
        <source>Segmen&amp;tation (%n segments)</source>
        <translation>
            <numerusform>Segmen&amp;tierung (%n Segment)</numerusform>
            <numerusform>Segmen&amp;tierung (%n Segmente)</numerusform>
        </translation>
    </message>
    <message>
        <source>Segmen&amp;tation (none is shown)</source>
        <translation>Segmen&amp;tierung (keine wird gezeigt)</translation>
    </message>
    <message>
        <source>Segmentation</source>
        <translation>Segmentierung</translation>
    </message>
    <message>
        <source>The segments that are shown, with labels, colours and codes, in one object</source>
        <translation>Die gezeigten Segmente, mit Labels, Farben und Codes, in einem Objekt</translation>
    </message>
    <message>
        <source>What Macula makes gets a pseudonym and new UIDs. Files are sent as they are. A face can still be seen.</source>
        <translation>Was Macula erstellt, erhält ein Pseudonym und neue UIDs. Dateien werden gesendet, wie sie sind. Ein Gesicht ist trotzdem zu erkennen.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SeriesStrip</name>
    <message>
        <source>Series of the selected study</source>
        <translation>Serien der gewählten Studie</translation>
    </message>
    <message>
        <source>What the archive has of the selected study, before it is fetched</source>
        <translation>Was das Archiv von der gewählten Studie hat, bevor sie abgerufen wird</translation>
    </message>
    <message numerus="yes">
        <source>%n images</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bilder</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::SettingsController</name>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Language, look, keys, and what is kept</source>
        <translation>Sprache, Aussehen, Tasten und was aufbewahrt wird</translation>
    </message>
    <message>
        <source>The settings are saved. Language and sessions follow them from the next start.</source>
        <translation>Die Einstellungen sind gespeichert. Sprache und Sitzungen folgen ihnen ab dem nächsten Start.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SettingsDialog</name>
    <message>
        <source>&amp;High contrast: black, white and yellow</source>
        <translation>&amp;Hoher Kontrast: Schwarz, Weiß und Gelb</translation>
    </message>
    <message>
        <source>&amp;Patient and study over pictures</source>
        <translation>&amp;Patient und Studie über Bildern</translation>
    </message>
    <message>
        <source>DICOM pictures &amp;without patient and study</source>
        <translation>DICOM-Bilder &amp;ohne Patient und Studie</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Pages of settings</source>
        <translation>Seiten der Einstellungen</translation>
    </message>
    <message>
        <source>Left and Right go from page to page</source>
        <translation>Links und Rechts gehen von Seite zu Seite</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Take all pages as they are</source>
        <translation>Alle Seiten so übernehmen</translation>
    </message>
    <message>
        <source>Change nothing</source>
        <translation>Nichts ändern</translation>
    </message>
    <message>
        <source>What was chosen on the command line counts more, until the program ends.</source>
        <translation>Was auf der Befehlszeile gewählt wurde, gilt mehr, bis das Programm endet.</translation>
    </message>
    <message>
        <source>These settings are not kept: the program was started so.</source>
        <translation>Diese Einstellungen werden nicht aufbewahrt: das Programm wurde so gestartet.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Of the window, and how numbers are written; from the next start on</source>
        <translation>Des Fensters, und wie Zahlen geschrieben werden; ab dem nächsten Start</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Instead of the dark window; at once</source>
        <translation>Statt des dunklen Fensters; sofort</translation>
    </message>
    <message>
        <source>Size of letters, times that of the desktop</source>
        <translation>Schriftgröße, mal die des Desktops</translation>
    </message>
    <message>
        <source>Times the size of the desktop&apos;s letters, 0.8 to 2; at once</source>
        <translation>Mal die Schriftgröße des Desktops, 0,8 bis 2; sofort</translation>
    </message>
    <message>
        <source>Patient and study over pictures</source>
        <translation>Patient und Studie über Bildern</translation>
    </message>
    <message>
        <source>When the window opens; N hides and shows them at any time</source>
        <translation>Wenn das Fenster sich öffnet; N blendet sie jederzeit aus und ein</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Schrift</translation>
    </message>
    <message>
        <source>Quality of saved pictures</source>
        <translation>Qualität gespeicherter Bilder</translation>
    </message>
    <message>
        <source>What Save Picture begins with: more samples per pixel take more time</source>
        <translation>Womit Bild speichern beginnt: mehr Abtastungen je Pixel brauchen mehr Zeit</translation>
    </message>
    <message>
        <source>DICOM pictures without patient and study</source>
        <translation>DICOM-Bilder ohne Patient und Studie</translation>
    </message>
    <message>
        <source>What Save Picture begins with: nothing of the patient is written, and all UIDs are new</source>
        <translation>Womit Bild speichern beginnt: vom Patienten wird nichts geschrieben, und alle UIDs sind neu</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualität</translation>
    </message>
    <message>
        <source>Folder of stored sessions</source>
        <translation>Ordner der gespeicherten Sitzungen</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Wählen…</translation>
    </message>
    <message>
        <source>Choose the folder of stored sessions</source>
        <translation>Den Ordner der gespeicherten Sitzungen wählen</translation>
    </message>
    <message>
        <source>Choose a folder; it must be empty, or one that Macula made</source>
        <translation>Einen Ordner wählen; er muss leer sein oder von Macula stammen</translation>
    </message>
    <message>
        <source>Days that studies are kept</source>
        <translation>Tage, die Studien aufbewahrt werden</translation>
    </message>
    <message>
        <source>What was not opened for so many days is deleted at the start, 1 to %1 days; nothing is deleted with 0</source>
        <translation>Was so viele Tage nicht geöffnet wurde, wird beim Start gelöscht, 1 bis %1 Tage; mit 0 wird nichts gelöscht</translation>
    </message>
    <message>
        <source>for ever</source>
        <translation>für immer</translation>
    </message>
    <message>
        <source> days</source>
        <translation> Tage</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Aufbewahren</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n samples</source>
        <translation>
            <numerusform>%1: %n Abtastung</numerusform>
            <numerusform>%1: %n Abtastungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Where previews, and how studies were left, are kept; empty: the usual folder. From the next start on; what is in the old folder stays there.</source>
        <translation>Wo Vorschauen und der letzte Stand von Studien aufbewahrt werden; leer: der übliche Ordner. Ab dem nächsten Start; was im alten Ordner ist, bleibt dort.</translation>
    </message>
    <message>
        <source>Room for stored previews in MB</source>
        <translation>Platz für gespeicherte Vorschauen in MB</translation>
    </message>
    <message>
        <source>Of all stored previews together, in MB; above it those that were not used for longest go. From the next start on.</source>
        <translation>Aller gespeicherten Vorschauen zusammen, in MB; darüber gehen die, die am längsten nicht gebraucht wurden. Ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>&amp;Previews</source>
        <translation>&amp;Vorschauen</translation>
    </message>
    <message>
        <source>Names and IDs are not kept, but previews and views tell as much of a patient as pictures do.</source>
        <translation>Namen und IDs werden nicht aufbewahrt, aber Vorschauen und Ansichten verraten so viel von einem Patienten wie Bilder.</translation>
    </message>
    <message>
        <source>Archives</source>
        <translation>Archive</translation>
    </message>
    <message>
        <source>Other studies of the patient</source>
        <translation>Andere Studien des Patienten</translation>
    </message>
    <message>
        <source>When a study from an archive is open, its archive is asked for others of this patient</source>
        <translation>Ist eine Studie aus einem Archiv geöffnet, wird dieses nach anderen des Patienten gefragt</translation>
    </message>
    <message>
        <source>Do not search</source>
        <translation>Nicht suchen</translation>
    </message>
    <message>
        <source>List them</source>
        <translation>Auflisten</translation>
    </message>
    <message>
        <source>List them, and fetch the last two to compare with</source>
        <translation>Auflisten, und die letzten beiden zum Vergleich abrufen</translation>
    </message>
    <message>
        <source>&amp;Other studies of the patient</source>
        <translation>&amp;Andere Studien des Patienten</translation>
    </message>
    <message>
        <source>Macula fetches earlier studies of the last five years that hold the same kind of images. The panel Archive is where archives are set up.</source>
        <translation>Macula ruft frühere Studien der letzten fünf Jahre ab, die Bilder derselben Art enthalten. Archive werden im Bereich Archiv eingerichtet.</translation>
    </message>
    <message>
        <source>Receiving</source>
        <translation>Empfang</translation>
    </message>
    <message>
        <source>Mouse on slices and images</source>
        <translation>Maus auf Schichten und Bildern</translation>
    </message>
    <message>
        <source>What dragging does; at once. On slices tools other than the cross-hair keep the left button</source>
        <translation>Was Ziehen tut; sofort. Auf Schichten behalten andere Werkzeuge als das Fadenkreuz die linke Taste</translation>
    </message>
    <message>
        <source>&amp;Mouse</source>
        <translation>&amp;Maus</translation>
    </message>
    <message>
        <source>Cross-hair left, move middle, window right</source>
        <translation>Fadenkreuz links, Schieben Mitte, Fenster rechts</translation>
    </message>
    <message>
        <source>Window left, move middle, zoom right</source>
        <translation>Fenster links, Schieben Mitte, Zoom rechts</translation>
    </message>
    <message>
        <source>Slices left, window middle, zoom right</source>
        <translation>Schichten links, Fenster Mitte, Zoom rechts</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ShownAdditions</name>
    <message>
        <source>There is not enough memory for the second volume in 3D.</source>
        <translation>Für das zweite Volumen in 3D ist nicht genug Speicher da.</translation>
    </message>
    <message>
        <source>Close other programs, or look at it on slices.</source>
        <translation>Schließen Sie andere Programme, oder sehen Sie es auf Schichten an.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ShownVolume</name>
    <message>
        <source>Table</source>
        <translation>Tisch</translation>
    </message>
    <message>
        <source>Open view</source>
        <translation>Ansicht öffnen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SliceCine</name>
    <message>
        <source>Cine</source>
        <translation>Cine</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SlicePopups</name>
    <message>
        <source>Label</source>
        <translation>Beschriftung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SliceTravel</name>
    <message>
        <source>Cross-hair</source>
        <translation>Fadenkreuz</translation>
    </message>
    <message>
        <source>Second volume moved</source>
        <translation>Zweites Volumen verschoben</translation>
    </message>
    <message>
        <source>Slice</source>
        <translation>Schicht</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SliceView</name>
    <message>
        <source>%1 slices</source>
        <translation>%1e Schichten</translation>
    </message>
    <message>
        <source>%1 slices of the second volume</source>
        <translation>%1e Schichten des zweiten Volumens</translation>
    </message>
    <message>
        <source>%1 slices, in mm. Wheel: next slice; right drag: window; right click: windows</source>
        <translation>%1e Schichten, in mm. Rad: nächste Schicht; rechts ziehen: Fensterung; Rechtsklick: Fensterungen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SourceDialog</name>
    <message>
        <source>Archives</source>
        <translation>Archive</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiv</translation>
    </message>
    <message>
        <source>Which archive is changed here</source>
        <translation>Welches Archiv hier geändert wird</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>What you call it</source>
        <translation>Wie Sie es nennen</translation>
    </message>
    <message>
        <source>It speaks</source>
        <translation>Es spricht</translation>
    </message>
    <message>
        <source>Which of the two the archive offers; its administrator knows</source>
        <translation>Welches der beiden das Archiv bietet; seine Verwaltung weiß es</translation>
    </message>
    <message>
        <source>DICOM (DIMSE)</source>
        <translation>DICOM (DIMSE)</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>Name or address of the archive&apos;s machine</source>
        <translation>Name oder Adresse des Rechners, auf dem das Archiv läuft</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Usually 104 or 11112</source>
        <translation>Meist 104 oder 11112</translation>
    </message>
    <message>
        <source>Its AE title</source>
        <translation>Sein AE-Titel</translation>
    </message>
    <message>
        <source>1 to 16 characters</source>
        <translation>1 bis 16 Zeichen</translation>
    </message>
    <message>
        <source>Our AE title</source>
        <translation>Unser AE-Titel</translation>
    </message>
    <message>
        <source>As the archive knows this program; tell its administrator</source>
        <translation>Unter dem das Archiv dieses Programm kennt; nennen Sie ihn seiner Verwaltung</translation>
    </message>
    <message>
        <source>Images come by</source>
        <translation>Bilder kommen per</translation>
    </message>
    <message>
        <source>C-GET needs no port of ours; C-MOVE needs one, which the archive must know</source>
        <translation>C-GET braucht keinen Port von uns; C-MOVE braucht einen, den das Archiv kennen muss</translation>
    </message>
    <message>
        <source>what it accepts</source>
        <translation>was das Archiv akzeptiert</translation>
    </message>
    <message>
        <source>C-GET</source>
        <translation>C-GET</translation>
    </message>
    <message>
        <source>C-MOVE</source>
        <translation>C-MOVE</translation>
    </message>
    <message>
        <source>Our port</source>
        <translation>Unser Port</translation>
    </message>
    <message>
        <source>For C-MOVE: where Macula receives while a study is fetched; 0: nowhere</source>
        <translation>Für C-MOVE: wo Macula empfängt, während eine Studie abgerufen wird; 0: nirgends</translation>
    </message>
    <message>
        <source>Encrypt the connection (TLS)</source>
        <translation>Die Verbindung verschlüsseln (TLS)</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Of the DICOMweb service, as https://pacs.example.org/dicom-web</source>
        <translation>Die des DICOMweb-Dienstes, wie https://pacs.hospital/dicom-web</translation>
    </message>
    <message>
        <source>User</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>Empty: nobody signs in</source>
        <translation>Leer: niemand meldet sich an</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Kept in a file that only you can read</source>
        <translation>Wird in einer Datei aufbewahrt, die nur Sie lesen können</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Try the archive step by step</source>
        <translation>Das Archiv Schritt für Schritt prüfen</translation>
    </message>
    <message>
        <source>A new one</source>
        <translation>Ein neues</translation>
    </message>
    <message>
        <source>Your administrator has set up this archive.</source>
        <translation>Ihre Systemverwaltung hat dieses Archiv eingerichtet.</translation>
    </message>
    <message>
        <source>Saved.</source>
        <translation>Gespeichert.</translation>
    </message>
    <message>
        <source>Trying…</source>
        <translation>Es wird geprüft…</translation>
    </message>
    <message>
        <source>Removed.</source>
        <translation>Entfernt.</translation>
    </message>
    <message>
        <source>Another archive has this name already. Choose another name.</source>
        <translation>Ein anderes Archiv hat diesen Namen schon. Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>The archive must offer it at this port</source>
        <translation>Das Archiv muss sie an diesem Port anbieten</translation>
    </message>
    <message>
        <source>Keep these settings</source>
        <translation>Diese Einstellungen behalten</translation>
    </message>
    <message>
        <source>Forget this archive and its password; what was fetched stays</source>
        <translation>Dieses Archiv und sein Passwort vergessen; was abgerufen wurde, bleibt</translation>
    </message>
    <message>
        <source>Signed in.</source>
        <translation>Angemeldet.</translation>
    </message>
    <message>
        <source>Sign In…</source>
        <translation>Anmelden…</translation>
    </message>
    <message>
        <source>Sign in at this archive by a browser</source>
        <translation>Sich mit einem Browser bei diesem Archiv anmelden</translation>
    </message>
    <message>
        <source>Asking for a code…</source>
        <translation>Ein Code wird angefordert…</translation>
    </message>
    <message>
        <source>Sign in with a browser, on this device or another, at %1. The code is %2.</source>
        <translation>Melden Sie sich mit einem Browser an, auf diesem oder einem anderen Gerät, unter %1. Der Code ist %2.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::StateController</name>
    <message>
        <source>How this study was left cannot be read; it is shown as when opened first.</source>
        <translation>Wie diese Studie verlassen wurde, kann nicht gelesen werden; sie wird wie beim ersten Öffnen gezeigt.</translation>
    </message>
    <message>
        <source>The preset %1 is not made for this kind of volume; %2 is used instead.</source>
        <translation>Die Voreinstellung %1 ist nicht für solche Volumen gemacht; stattdessen wird %2 verwendet.</translation>
    </message>
    <message>
        <source>This study is shown as it was left. The View menu shows it as when first opened.</source>
        <translation>Diese Studie wird gezeigt, wie sie verlassen wurde. Das Menü Ansicht zeigt sie wie beim ersten Öffnen.</translation>
    </message>
    <message>
        <source>Show as when first opened</source>
        <translation>Wie beim ersten Öffnen zeigen</translation>
    </message>
    <message>
        <source>Preset, lights, clip, look and camera that a study has which nobody has seen yet</source>
        <translation>Voreinstellung, Beleuchtung, Beschnitt, Darstellung und Kamera einer Studie, die noch niemand gesehen hat</translation>
    </message>
    <message>
        <source>Show afresh</source>
        <translation>Neu zeigen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::StatusController</name>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>How true the picture is</source>
        <translation>Wie getreu das Bild ist</translation>
    </message>
    <message>
        <source>Voxels and their size</source>
        <translation>Voxel und ihre Größe</translation>
    </message>
    <message>
        <source>The preview with all pixels that is shown while a hand moves; it gets sharper while nothing moves</source>
        <translation>Die Vorschau mit allen Pixeln, die während der Bewegung gezeigt wird; sie wird schärfer, solange sich nichts bewegt</translation>
    </message>
    <message>
        <source>Pixels, pictures per second</source>
        <translation>Pixel, Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>No study is open</source>
        <translation>Keine Studie ist offen</translation>
    </message>
    <message>
        <source>No picture</source>
        <translation>Kein Bild</translation>
    </message>
    <message>
        <source>The picture in 3D is being made…</source>
        <translation>Das Bild in 3D entsteht…</translation>
    </message>
    <message>
        <source>Starting the graphics device again…</source>
        <translation>Das Grafikgerät wird neu gestartet…</translation>
    </message>
    <message>
        <source>The graphics device stopped responding and is started again; the picture is made anew. If this comes back, update the graphics driver.</source>
        <translation>Das Grafikgerät hat nicht mehr geantwortet und wird neu gestartet; das Bild wird neu erstellt. Wenn das wieder vorkommt, aktualisieren Sie den Grafiktreiber.</translation>
    </message>
    <message>
        <source>The graphics device stopped responding and was started again. If this comes back, update the graphics driver.</source>
        <translation>Das Grafikgerät hat nicht mehr geantwortet und wurde neu gestartet. Wenn das wieder vorkommt, aktualisieren Sie den Grafiktreiber.</translation>
    </message>
    <message numerus="yes">
        <source>, %n samples left out</source>
        <translation>
            <numerusform>, %n Abtastung ausgelassen</numerusform>
            <numerusform>, %n Abtastungen ausgelassen</numerusform>
        </translation>
    </message>
    <message>
        <source>, less than the full resolution</source>
        <translation>, weniger als die volle Auflösung</translation>
    </message>
    <message>
        <source>, %1/s</source>
        <translation>, %1/s</translation>
    </message>
    <message>
        <source>Images, not in 3D</source>
        <translation>Bilder, nicht in 3D</translation>
    </message>
</context>
<context>
    <name>macula::viewer::SteepChoice</name>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Steep</source>
        <translation>Steil</translation>
    </message>
    <message>
        <source>Which curves are edited</source>
        <translation>Welche Kurven bearbeitet werden</translation>
    </message>
    <message>
        <source>Curves of matter whose values change little around a place, or steeply</source>
        <translation>Kurven der Materie, deren Werte sich um einen Ort wenig oder steil ändern</translation>
    </message>
    <message>
        <source>Remove steep</source>
        <translation>Steile entfernen</translation>
    </message>
    <message>
        <source>Add steep</source>
        <translation>Steile hinzufügen</translation>
    </message>
    <message>
        <source>Remove the curves of steep matter</source>
        <translation>Die Kurven steiler Materie entfernen</translation>
    </message>
    <message>
        <source>Add curves for steep matter</source>
        <translation>Kurven für steile Materie hinzufügen</translation>
    </message>
    <message>
        <source>All matter has the curves of flat matter again; can be undone</source>
        <translation>Alle Materie hat wieder die Kurven der flachen; kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Where values change steeply, matter gets curves of its own</source>
        <translation>Wo Werte sich steil ändern, erhält die Materie eigene Kurven</translation>
    </message>
</context>
<context>
    <name>macula::viewer::StudyBrowser</name>
    <message>
        <source>Search the studies of the folder</source>
        <translation>Die Studien des Ordners durchsuchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Name, ID, date, modality or description; all words have to be there. Down or Enter goes to the list, Esc ends the search.</source>
        <translation>Name, ID, Datum, Modalität oder Beschreibung; alle Wörter müssen vorkommen. Ab oder Eingabe geht zur Liste, Esc beendet die Suche.</translation>
    </message>
    <message>
        <source>Studies, series and volumes of the folder</source>
        <translation>Studien, Serien und Volumen des Ordners</translation>
    </message>
    <message>
        <source>No folder of images is open.</source>
        <translation>Kein Ordner mit Bildern ist offen.</translation>
    </message>
    <message>
        <source>There are no studies in this folder.</source>
        <translation>In diesem Ordner sind keine Studien.</translation>
    </message>
    <message>
        <source>Nothing matches “%1”.</source>
        <translation>Nichts passt zu „%1“.</translation>
    </message>
    <message>
        <source>The folder is still being read. What is in it can be opened then.</source>
        <translation>Der Ordner wird noch gelesen. Was darin ist, kann danach geöffnet werden.</translation>
    </message>
    <message>
        <source>Open &amp;Beside</source>
        <translation>Da&amp;neben öffnen</translation>
    </message>
    <message>
        <source>Show this volume beside the study that is open</source>
        <translation>Dieses Volumen neben der offenen Studie zeigen</translation>
    </message>
    <message>
        <source>What is in the folder; sizes of voxels are in mm. One click selects; a double click or Enter opens, be it a volume or a view of one that was kept. The files are only read, and stay where they are.</source>
        <translation>Was im Ordner ist; Voxelgrößen sind in mm. Ein Klick wählt aus; ein Doppelklick oder Eingabe öffnet, sei es ein Volumen oder eine Ansicht davon, die aufgehoben wurde. Die Dateien werden nur gelesen und bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>Nothing of this folder is open.</source>
        <translation>Aus diesem Ordner ist nichts geöffnet.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::StudyFetcher</name>
    <message>
        <source>Fetching a study</source>
        <translation>Eine Studie wird abgerufen</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation>
            <numerusform>noch %n weitere</numerusform>
            <numerusform>noch %n weitere</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::StudyTreeModel</name>
    <message>
        <source>Open now</source>
        <translation>Jetzt offen</translation>
    </message>
    <message>
        <source>Seen before; opens as it was left</source>
        <translation>Schon gesehen; öffnet sich, wie sie verlassen wurde</translation>
    </message>
    <message>
        <source>This cannot be opened.</source>
        <translation>Das kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>A double click or Enter opens it.</source>
        <translation>Ein Doppelklick oder Eingabe öffnet es.</translation>
    </message>
    <message>
        <source>Cannot be opened: %1</source>
        <translation>Kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>A double click or Enter opens its series, and shows it so.</source>
        <translation>Ein Doppelklick oder die Eingabetaste öffnet die Serie dazu und zeigt sie so.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TableController</name>
    <message>
        <source>Looking for the table</source>
        <translation>Der Tisch wird gesucht</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TableRemoval</name>
    <message>
        <source>&amp;Remove Table</source>
        <translation>&amp;Tisch entfernen</translation>
    </message>
    <message>
        <source>No study is open</source>
        <translation>Keine Studie ist offen</translation>
    </message>
    <message>
        <source>The table can be left out of CT in Hounsfield units only</source>
        <translation>Der Tisch kann nur bei CT in Hounsfield-Einheiten weggelassen werden</translation>
    </message>
    <message>
        <source>Leave out the table and what else lies beside the patient</source>
        <translation>Den Tisch und was sonst neben dem Patienten liegt weglassen</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TimeCurveDialog</name>
    <message>
        <source>Curve over Phases</source>
        <translation>Verlauf über die Phasen</translation>
    </message>
    <message>
        <source>&amp;Copy as a Table</source>
        <translation>Als Tabelle &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Save as a Table…</source>
        <translation>Als Tabelle &amp;speichern…</translation>
    </message>
    <message>
        <source>Save the curve</source>
        <translation>Die Kurve speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>The curve is written to %1.</source>
        <translation>Die Kurve ist in %1 geschrieben.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ToolBox</name>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Four Panes</source>
        <translation>Vier Bildfelder</translation>
    </message>
    <message>
        <source>3D Only</source>
        <translation>Nur 3D</translation>
    </message>
    <message>
        <source>Axial Only</source>
        <translation>Nur axial</translation>
    </message>
    <message>
        <source>Coronal Only</source>
        <translation>Nur koronar</translation>
    </message>
    <message>
        <source>Sagittal Only</source>
        <translation>Nur sagittal</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 (%2): %3</source>
        <translation>%1 (%2): %3</translation>
    </message>
    <message>
        <source>Slab</source>
        <translation>Slab</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Slab thickness in mm</source>
        <translation>Dicke des Slabs in mm</translation>
    </message>
    <message>
        <source>Thickness of the slab, 0 to %1 mm; 0 is the plane alone</source>
        <translation>Dicke des Slabs, 0 bis %1 mm; 0 ist die Ebene allein</translation>
    </message>
    <message>
        <source>Slab Thickness</source>
        <translation>Dicke des Slabs</translation>
    </message>
    <message>
        <source>Slab Kind</source>
        <translation>Art des Slabs</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Invertieren</translation>
    </message>
    <message>
        <source>White and black change places on slices; values stay as they are</source>
        <translation>Weiß und Schwarz tauschen auf Schichten den Platz; Werte bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Acquired Planes</source>
        <translation>Aufnahmeebenen</translation>
    </message>
    <message>
        <source>Slices in the planes of the acquisition, or in those of the patient</source>
        <translation>Schichten in den Ebenen der Aufnahme oder in denen des Patienten</translation>
    </message>
    <message>
        <source>Cine</source>
        <translation>Cine</translation>
    </message>
    <message>
        <source>Run through the slices, or stop</source>
        <translation>Die Schichten durchlaufen oder anhalten</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Slab kind: %1</source>
        <translation>Art des Slabs: %1</translation>
    </message>
    <message>
        <source>What is shown of the values across the slab: %1</source>
        <translation>Was von den Werten durch den Slab gezeigt wird: %1</translation>
    </message>
    <message>
        <source>Straight Planes</source>
        <translation>Gerade Ebenen</translation>
    </message>
    <message>
        <source>Planes that were turned are straight again</source>
        <translation>Gedrehte Ebenen sind wieder gerade</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TransferCurve</name>
    <message>
        <source>Transfer function: opacity and colour over value</source>
        <translation>Übertragungsfunktion: Deckkraft und Farbe über dem Wert</translation>
    </message>
    <message>
        <source>Values%1 from left to right, opacity (0 to 1, of a layer %2 mm thick) upwards, with how often each value is in the volume behind it; colours below.
Drag a point; double click adds one, Delete removes it; arrows move it, with Shift finer.
Right drag, or Alt + left drag, beside the points: shift all, and widen upwards; with Ctrl: more opaque upwards.
Wheel: zoom the axis; drag the axis to move it; double click on it shows all.</source>
        <translation>Werte%1 von links nach rechts, Deckkraft (0 bis 1, einer %2 mm dicken Lage) nach oben, dahinter, wie oft jeder Wert im Volumen ist; darunter Farben.
Einen Punkt ziehen; Doppelklick fügt einen hinzu, Entf entfernt ihn; Pfeile verschieben ihn, mit Umschalt feiner.
Rechts ziehen oder Alt + links ziehen neben den Punkten: alle verschieben, nach oben verbreitern; mit Strg: nach oben deckender.
Rad: die Achse zoomen; die Achse ziehen verschiebt sie; Doppelklick darauf zeigt alles.</translation>
    </message>
    <message>
        <source> in %1</source>
        <translation> in %1</translation>
    </message>
    <message>
        <source>Colour point %1 of %2 at %3</source>
        <translation>Farbpunkt %1 von %2 bei %3</translation>
    </message>
    <message>
        <source>Opacity point %1 of %2 at %3, opacity %4</source>
        <translation>Deckkraftpunkt %1 von %2 bei %3, Deckkraft %4</translation>
    </message>
    <message numerus="yes">
        <source>%n points; none is selected. Arrows shift and widen all of them, Tab goes through them.</source>
        <translation>
            <numerusform>%n Punkt; keiner ist ausgewählt. Pfeile verschieben und weiten alle, Tab geht durch sie.</numerusform>
            <numerusform>%n Punkte; keiner ist ausgewählt. Pfeile verschieben und weiten alle, Tab geht durch sie.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::TransferDrag</name>
    <message>
        <source>Transfer function: shifted by %1%2, %3 times as wide</source>
        <translation>Übertragungsfunktion: um %1%2 verschoben, %3-mal so breit</translation>
    </message>
    <message>
        <source>The transfer function cannot be moved yet: how it lies on these values is still counted.</source>
        <translation>Die Übertragungsfunktion kann noch nicht verschoben werden: wie sie auf diesen Werten liegt, wird noch gezählt.</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
</context>
<context>
    <name>macula::viewer::TransferFunctionEditor</name>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern als…</translation>
    </message>
    <message>
        <source>Which preset is edited</source>
        <translation>Welche Voreinstellung bearbeitet wird</translation>
    </message>
    <message>
        <source>Reset the transfer function</source>
        <translation>Die Übertragungsfunktion zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the preset as it was chosen; can be undone</source>
        <translation>Zurück zur Voreinstellung, wie sie gewählt wurde; kann rückgängig gemacht werden</translation>
    </message>
    <message>
        <source>Save the transfer function as a preset</source>
        <translation>Die Übertragungsfunktion als Voreinstellung speichern</translation>
    </message>
    <message>
        <source>Keep this transfer function as a preset of your own</source>
        <translation>Diese Übertragungsfunktion als eigene Voreinstellung behalten</translation>
    </message>
    <message>
        <source>Transfer function</source>
        <translation>Übertragungsfunktion</translation>
    </message>
    <message>
        <source>Reset transfer function</source>
        <translation>Übertragungsfunktion zurücksetzen</translation>
    </message>
    <message>
        <source>Open a study to edit its transfer function.</source>
        <translation>Öffnen Sie eine Studie, um ihre Übertragungsfunktion zu bearbeiten.</translation>
    </message>
    <message>
        <source>%1: your copy of %2.</source>
        <translation>%1: Ihre Kopie von %2.</translation>
    </message>
    <message>
        <source>%1, as it was chosen. The first change makes a copy.</source>
        <translation>%1, wie gewählt. Die erste Änderung legt eine Kopie an.</translation>
    </message>
    <message>
        <source>It is being fitted to the values of the volume.</source>
        <translation>Sie wird an die Werte des Volumens angepasst.</translation>
    </message>
    <message>
        <source>It is stretched to this volume; values are those of the volume.</source>
        <translation>Sie ist auf dieses Volumen gestreckt; Werte sind die des Volumens.</translation>
    </message>
    <message>
        <source>It is made for other units than those of the series.</source>
        <translation>Sie ist für andere Einheiten gemacht als die der Serie.</translation>
    </message>
    <message>
        <source>Its gradient opacity is kept.</source>
        <translation>Ihre Gradienten-Deckkraft bleibt erhalten.</translation>
    </message>
    <message>
        <source>These are its curves of steep matter.</source>
        <translation>Dies sind ihre Kurven steiler Materie.</translation>
    </message>
    <message>
        <source>These are its curves of flat matter.</source>
        <translation>Dies sind ihre Kurven flacher Materie.</translation>
    </message>
    <message>
        <source>Matter</source>
        <translation>Materie</translation>
    </message>
    <message>
        <source>Show how matter scatters light</source>
        <translation>Zeigen, wie Materie Licht streut</translation>
    </message>
    <message>
        <source>How matter scatters light: its surface, and anisotropy</source>
        <translation>Wie Materie Licht streut: ihre Oberfläche und Anisotropie</translation>
    </message>
</context>
<context>
    <name>macula::viewer::UndoActions</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last change back: %1</source>
        <translation>Die letzte Änderung zurücknehmen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Make it again: %1</source>
        <translation>Noch einmal machen: %1</translation>
    </message>
</context>
<context>
    <name>macula::viewer::View3dController</name>
    <message>
        <source>Fit what is visible</source>
        <translation>Sichtbares einpassen</translation>
    </message>
    <message>
        <source>Cube and scale</source>
        <translation>Würfel und Maßstab</translation>
    </message>
    <message>
        <source>From where the patient is seen, and how long a centimetre is: with parallel rays everywhere, else at the depth of what the camera turns around</source>
        <translation>Von wo der Patient gesehen wird und wie lang ein Zentimeter ist: bei parallelen Strahlen überall, sonst in der Tiefe dessen, um das sich die Kamera dreht</translation>
    </message>
    <message>
        <source>Parallel rays</source>
        <translation>Parallele Strahlen</translation>
    </message>
    <message>
        <source>The same millimetres for each pixel at every depth</source>
        <translation>In jeder Tiefe gleich viele Millimeter je Pixel</translation>
    </message>
    <message>
        <source>Trace where the pointer is, while moving</source>
        <translation>Bei Bewegung dort verfolgen, wo der Zeiger ist</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ViewerWidget</name>
    <message>
        <source>Cube and scale</source>
        <translation>Würfel und Maßstab</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fensterung</translation>
    </message>
</context>
<context>
    <name>macula::viewer::ViewsController</name>
    <message>
        <source>Open &amp;View…</source>
        <translation>&amp;Ansicht öffnen…</translation>
    </message>
    <message>
        <source>Show this study as it was when a view was saved</source>
        <translation>Diese Studie so zeigen, wie sie beim Speichern einer Ansicht war</translation>
    </message>
    <message>
        <source>&amp;Save View…</source>
        <translation>Ansicht &amp;speichern…</translation>
    </message>
    <message>
        <source>All that was chosen, and the camera, for another time</source>
        <translation>Alles, was gewählt wurde, und die Kamera, für ein andermal</translation>
    </message>
    <message>
        <source>Open a view</source>
        <translation>Ansicht öffnen</translation>
    </message>
    <message>
        <source>Views (*.json)</source>
        <translation>Ansichten (*.json)</translation>
    </message>
    <message>
        <source>There is no view to save yet.</source>
        <translation>Es gibt noch keine Ansicht zu speichern.</translation>
    </message>
    <message>
        <source>Save the view</source>
        <translation>Ansicht speichern</translation>
    </message>
</context>
<context>
    <name>macula::viewer::VolumeChoice</name>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Which volume of the folder is open; choose another one here</source>
        <translation>Welches Volumen des Ordners offen ist; wählen Sie hier ein anderes</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>macula::viewer::WaitingBar</name>
    <message>
        <source>Send Now</source>
        <translation>Jetzt senden</translation>
    </message>
    <message>
        <source>Send all that waits</source>
        <translation>Alles senden, was wartet</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>What waits, of whom, and why</source>
        <translation>Was wartet, von wem und warum</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>It stays in the queue: File, Waiting for Archives</source>
        <translation>Es bleibt in der Warteschlange: Datei, „Warteschlange für Archive“</translation>
    </message>
    <message numerus="yes">
        <source>%n objects wait for %1.</source>
        <translation>
            <numerusform>%n Objekt wartet auf %1.</numerusform>
            <numerusform>%n Objekte warten auf %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>macula::viewer::WatchController</name>
    <message>
        <source>&amp;Watched Folders</source>
        <translation>&amp;Überwachte Ordner</translation>
    </message>
    <message>
        <source>&amp;Watch a Folder…</source>
        <translation>Ordner &amp;überwachen…</translation>
    </message>
    <message>
        <source>Say when a study appears in a folder; nothing is opened by itself</source>
        <translation>Melden, wenn in einem Ordner eine Studie erscheint; von selbst wird nichts geöffnet</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>einen Ordner</translation>
    </message>
    <message>
        <source>%1 (cannot be read now)</source>
        <translation>%1 (jetzt nicht lesbar)</translation>
    </message>
    <message>
        <source>Stop Watching %1</source>
        <translation>%1 nicht mehr überwachen</translation>
    </message>
    <message>
        <source>Choose a folder to watch</source>
        <translation>Ordner zum Überwachen wählen</translation>
    </message>
    <message>
        <source>This folder is watched already.</source>
        <translation>Dieser Ordner wird schon überwacht.</translation>
    </message>
    <message>
        <source>No more folders can be watched.</source>
        <translation>Mehr Ordner können nicht überwacht werden.</translation>
    </message>
    <message>
        <source>Stop watching another one first.</source>
        <translation>Beenden Sie zuerst die Überwachung eines anderen.</translation>
    </message>
    <message>
        <source>Macula now says when a study appears in this folder. What is there already is not told.</source>
        <translation>Macula meldet jetzt, wenn in diesem Ordner eine Studie erscheint. Was schon dort ist, wird nicht gemeldet.</translation>
    </message>
</context>
<context>
    <name>macula::viewer::WorkBar</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stop; what is shown now stays</source>
        <translation>Anhalten; was jetzt zu sehen ist, bleibt</translation>
    </message>
</context>
<context>
    <name>titles</name>
    <message>
        <source>Cinematic</source>
        <translation>Cinematic</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Klar</translation>
    </message>
    <message>
        <source>Ray cast</source>
        <translation>Volumen-Rendering</translation>
    </message>
    <message>
        <source>Maximum (MIP)</source>
        <translation>Maximum (MIP)</translation>
    </message>
    <message>
        <source>Minimum (MinIP)</source>
        <translation>Minimum (MinIP)</translation>
    </message>
    <message>
        <source>Average (X-ray)</source>
        <translation>Mittelwert (Röntgen)</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Liver</source>
        <translation>Leber</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Mediastinum</translation>
    </message>
    <message>
        <source>Angiography</source>
        <translation>Angiographie</translation>
    </message>
    <message>
        <source>SUV 0 to 5</source>
        <translation>SUV 0 bis 5</translation>
    </message>
    <message>
        <source>SUV 0 to 7</source>
        <translation>SUV 0 bis 7</translation>
    </message>
    <message>
        <source>SUV 0 to 15</source>
        <translation>SUV 0 bis 15</translation>
    </message>
    <message>
        <source>SUV 0 to 20</source>
        <translation>SUV 0 bis 20</translation>
    </message>
    <message>
        <source>Usual for PET</source>
        <translation>Üblich für PET</translation>
    </message>
    <message>
        <source>Of the series</source>
        <translation>Der Serie</translation>
    </message>
    <message>
        <source>All values</source>
        <translation>Alle Werte</translation>
    </message>
    <message>
        <source>anterior</source>
        <translation>anterior</translation>
    </message>
    <message>
        <source>posterior</source>
        <translation>posterior</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>superior</source>
        <translation>superior</translation>
    </message>
    <message>
        <source>inferior</source>
        <translation>inferior</translation>
    </message>
    <message>
        <source>Own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Own clip</source>
        <translation>Eigener Beschnitt</translation>
    </message>
    <message>
        <source>Presentation state</source>
        <translation>Presentation State</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Benutzerdefiniert</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>bearbeitet</translation>
    </message>
    <message>
        <source>Daylight</source>
        <translation>Tageslicht</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Headlight</source>
        <translation>Stirnlicht</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>Gegenlicht</translation>
    </message>
    <message>
        <source>Studio</source>
        <translation>Studio</translation>
    </message>
    <message>
        <source>Theatre</source>
        <translation>Operationssaal</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Only the front half</source>
        <translation>Nur die vordere Hälfte</translation>
    </message>
    <message>
        <source>Only a ball in the middle</source>
        <translation>Nur eine Kugel in der Mitte</translation>
    </message>
    <message>
        <source>Left upper front eighth taken out, with the slices on the cuts, air black</source>
        <translation>Linkes oberes vorderes Achtel herausgenommen, mit den Schichten auf den Schnitten, Luft schwarz</translation>
    </message>
    <message>
        <source>Left upper front eighth taken out, with the slices on the cuts</source>
        <translation>Linkes oberes vorderes Achtel herausgenommen, mit den Schichten auf den Schnitten</translation>
    </message>
    <message>
        <source>Opened from the front, with the slice on the cut, air black</source>
        <translation>Von vorn geöffnet, mit der Schicht auf dem Schnitt, Luft schwarz</translation>
    </message>
    <message>
        <source>Opened from the front, with the slice on the cut</source>
        <translation>Von vorn geöffnet, mit der Schicht auf dem Schnitt</translation>
    </message>
    <message>
        <source>Only the lower half</source>
        <translation>Nur die untere Hälfte</translation>
    </message>
    <message>
        <source>Only the patient&apos;s left half</source>
        <translation>Nur die linke Hälfte des Patienten</translation>
    </message>
    <message>
        <source>Only the back half</source>
        <translation>Nur die hintere Hälfte</translation>
    </message>
    <message>
        <source>Only the patient&apos;s right half</source>
        <translation>Nur die rechte Hälfte des Patienten</translation>
    </message>
    <message>
        <source>Only an axial slab through the middle, a tenth of the height</source>
        <translation>Nur ein axialer Slab durch die Mitte, ein Zehntel der Höhe</translation>
    </message>
    <message>
        <source>Only the upper half</source>
        <translation>Nur die obere Hälfte</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Cinematic abdomen</source>
        <translation>Cinematic Abdomen</translation>
    </message>
    <message>
        <source>Cinematic airways</source>
        <translation>Cinematic Atemwege</translation>
    </message>
    <message>
        <source>Cinematic aorta</source>
        <translation>Cinematic Aorta</translation>
    </message>
    <message>
        <source>Cinematic bone</source>
        <translation>Cinematic Knochen</translation>
    </message>
    <message>
        <source>Cinematic bronchi</source>
        <translation>Cinematic Bronchien</translation>
    </message>
    <message>
        <source>Cinematic chest</source>
        <translation>Cinematic Thorax</translation>
    </message>
    <message>
        <source>Cinematic colon</source>
        <translation>Cinematic Kolon</translation>
    </message>
    <message>
        <source>Cinematic coronary arteries</source>
        <translation>Cinematic Koronararterien</translation>
    </message>
    <message>
        <source>Cinematic teeth</source>
        <translation>Cinematic Zähne</translation>
    </message>
    <message>
        <source>Cinematic fat</source>
        <translation>Cinematic Fett</translation>
    </message>
    <message>
        <source>Cinematic head</source>
        <translation>Cinematic Kopf</translation>
    </message>
    <message>
        <source>Cinematic heart</source>
        <translation>Cinematic Herz</translation>
    </message>
    <message>
        <source>Cinematic kidneys</source>
        <translation>Cinematic Nieren</translation>
    </message>
    <message>
        <source>Cinematic liver</source>
        <translation>Cinematic Leber</translation>
    </message>
    <message>
        <source>Cinematic lung</source>
        <translation>Cinematic Lunge</translation>
    </message>
    <message>
        <source>Cinematic metal</source>
        <translation>Cinematic Metall</translation>
    </message>
    <message>
        <source>Cinematic micro-CT</source>
        <translation>Cinematic Mikro-CT</translation>
    </message>
    <message>
        <source>Cinematic MR brain</source>
        <translation>Cinematic MR Gehirn</translation>
    </message>
    <message>
        <source>Cinematic MR knee</source>
        <translation>Cinematic MR Knie</translation>
    </message>
    <message>
        <source>Cinematic MR skin</source>
        <translation>Cinematic MR Haut</translation>
    </message>
    <message>
        <source>Cinematic MR vessels</source>
        <translation>Cinematic MR Gefäße</translation>
    </message>
    <message>
        <source>Cinematic MR</source>
        <translation>Cinematic MR</translation>
    </message>
    <message>
        <source>Cinematic muscle</source>
        <translation>Cinematic Muskulatur</translation>
    </message>
    <message>
        <source>Cinematic PET</source>
        <translation>Cinematic PET</translation>
    </message>
    <message>
        <source>Cinematic skeleton</source>
        <translation>Cinematic Skelett</translation>
    </message>
    <message>
        <source>Cinematic skin</source>
        <translation>Cinematic Haut</translation>
    </message>
    <message>
        <source>Cinematic soft tissue</source>
        <translation>Cinematic Weichteile</translation>
    </message>
    <message>
        <source>Cinematic tendons</source>
        <translation>Cinematic Sehnen</translation>
    </message>
    <message>
        <source>Cinematic vessels</source>
        <translation>Cinematic Gefäße</translation>
    </message>
</context>
</TS>
