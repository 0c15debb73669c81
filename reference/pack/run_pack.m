% SPDX-License-Identifier: BSD-3-Clause
% Holds a contact code against the conformance pack (GNU Octave).
%
%     octave-cli --eval "exit(run_pack('A', {'level-a.csv'}))"
%     octave-cli --eval "exit(run_pack('B', {'cases.csv', 'hard-cases.csv'}))"
%
% edgeproof_answer.m is an example: put yours in its place. Levels A, B and C; README.md says what
% they ask. Status 0: every answer is within the level; 1: one is not; 2: there was nothing to hold.
function status = run_pack(level, files)
    header = ['id,kind,m,C,phi,alpha,t,R,a,P,M,E,Q,S,edge,u,quantity,scale,value,bound,' ...
              'binary64,hex,condition,ulps'];
    names = strsplit(header, ',');
    words = {'id', 'kind', 'edge', 'quantity', 'value', 'hex'};
    answered = 0;
    wrong = 0;
    not_there = 0;
    ratios = struct(); % answer/exact of wrong answers, by the first letter of the quantity
    status = 2;
    for i = 1:numel(files)
        file = fopen(files{i}, 'r');
        if file < 0
            printf('%s: cannot be read\n', files{i});
            return;
        end
        in_rows = false;
        rows = 0;
        stated = -1;
        while true
            line = fgetl(file);
            if ~ischar(line)
                break;
            end
            if ~isempty(line) && line(1) == '#'
                if strncmp(line, '# rows: ', 8)
                    stated = str2double(line(9:end));
                end
                continue;
            end
            if ~in_rows
                if ~strcmp(line, header)
                    printf('%s: the columns are those of another pack\n', files{i});
                    fclose(file);
                    return;
                end
                in_rows = true;
                continue;
            end
            rows = rows + 1;
            cells = strsplit(line, ',');
            question = struct();
            for k = 1:numel(names)
                if any(strcmp(names{k}, words))
                    question.(names{k}) = cells{k};
                else
                    question.(names{k}) = str2double(cells{k});
                end
            end
            value = edgeproof_answer(question); % [] where the code does not have this
            if isempty(value)
                not_there = not_there + 1;
                continue;
            end
            answered = answered + 1;
            if ~within(level, value, question)
                wrong = wrong + 1;
                letter = question.quantity(1);
                if ~isfield(ratios, letter)
                    ratios.(letter) = [];
                end
                ratios.(letter)(end + 1) = value / question.binary64;
                if wrong <= 10
                    printf('%s: %.17g, exact %.17g\n', question.id, value, question.binary64);
                end
            end
        end
        fclose(file);
        if rows ~= stated
            printf(['%s: the file is not whole: it has %d rows, and its line # rows has another ' ...
                    'number\n'], files{i}, rows);
            return;
        end
    end
    printf('level %s: %d answered, %d wrong, %d not answered\n', level, answered, wrong, ...
           not_there);
    print_causes(ratios);
    if wrong > 0
        status = 1;
    elseif answered > 0
        status = 0;
    end
end

% Names the factor where all wrong answers of a quantity, three or more, have the same one.
function print_causes(ratios)
    same_ratio = 0.01; % ratios that agree to this are one factor
    letters = fieldnames(ratios);
    for k = 1:numel(letters)
        found = ratios.(letters{k});
        middle = (min(found) + max(found)) / 2;
        same = max(found) - min(found) <= same_ratio * abs(middle) && ~any(isnan(found));
        if numel(found) < 3 || ~same || abs(middle - 1) <= same_ratio
            continue;
        end
        names = {};
        file = fopen('factors.txt', 'r');
        if file >= 0
            factors = textscan(file, '%s %f', 'CommentStyle', '#');
            fclose(file);
            names = factors{1}(abs(middle ./ factors{2} - 1) <= same_ratio);
        end
        if isempty(names)
            names = {'factor'};
        end
        printf('likely cause: the %d wrong answers for %s are %.6g times the exact ones: %s\n', ...
               numel(found), letters{k}, middle, strjoin(names, ' or '));
    end
end

% Whether an answer is within the level: a NaN is not.
function yes = within(level, value, question)
    off = abs(value - question.binary64);
    switch level
        case 'A'
            yes = off <= 0.01 * question.scale;
        case 'B'
            yes = off <= question.ulps * eps(abs(question.binary64));
        case 'C'
            yes = value == question.binary64;
        otherwise
            error('level %s is none of A, B, C', level);
    end
end
